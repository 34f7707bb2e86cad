// The least that a dynamically linked C++ program costs: the unit of the process benchmark.
int main() {}
