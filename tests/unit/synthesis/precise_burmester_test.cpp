#include "studies/synthesis/dyads/precise_burmester.hpp"

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "near_dyad.hpp"

namespace kinestat {
namespace {

using PrecisePosition = PositionJetsOf<BigFloat>;

PrecisePosition at(const char* x, const char* y, const char* angle) {
  return {.x = {BigFloat(x)}, .y = {BigFloat(y)}, .angle = {BigFloat(angle)}};
}

// Positions that several tasks have.
const PrecisePosition kShared1 = at("0.5815525930143709959744744544381568063908",
                                    "0.3836821224889589524233395664480953194858",
                                    "0.4721943757718848866841594406037809733252");
const PrecisePosition kShared2 = at("-0.669857795242094868123793971603153816713",
                                    "1.089767515374990855550219709950207498633",
                                    "0.1587043158650409598328021401387131093785");
const PrecisePosition kShared3 = at("-1.28529867753234000147107977966837263858",
                                    "-0.2392755398655244688595033148082279338325",
                                    "0.2990355495978719267920097503793596795225");
const PrecisePosition kShared4 = at("0.581552592686253477946843566499156047448",
                                    "0.3836821235481631006076343076706973882212",
                                    "0.4721943754381843273935509433072203374857");

// The dyads of the crank-rocker itself.
const Dyad kCrank{.kind = DyadKind::crank, .circle_point = {0.3, -0.2}, .centre_point = {0.0, 0.0}};
const Dyad kRocker{.kind = DyadKind::crank,
                   .circle_point = {3.5878044949658263, 1.0001423260940798},
                   .centre_point = {4.0, 0.5}};

/// Positions of a crank-rocker with 40 digits; dyads computed in arithmetic of 60 digits,
/// independently of this library.
struct PreciseTask {
  std::string name;
  std::vector<PrecisePosition> positions;
  std::vector<Dyad> dyads;
};

const std::vector<PreciseTask>& precise_tasks() {
  static const std::vector<PreciseTask> kTasks = {
      // case 7 P-P-P-P-P, crank-rocker, crank angles 20,60,110,200,300 deg
      {.name = "IC01",
       .positions = {kShared1,
                     at("0.157061328285480139476687323013723168535",
                        "0.9773495585877910760224526617293136170932",
                        "0.2741160142236409936609551245689544138123"),
                     kShared2,
                     kShared3,
                     at("0.1426801678725405031605941049223483701064",
                        "-0.9142181165987652956323746671647301128745",
                        "0.7220663691784570663018509001209616250547")},
       .dyads = {kRocker,
                 {.kind = DyadKind::crank,
                  .circle_point = {8.570704689977175, -0.053689203888129394},
                  .centre_point = {7.146148208877698, 3.5200675555395415}},
                 {.kind = DyadKind::crank,
                  .circle_point = {0.7316647678820477, 11.327055893298546},
                  .centre_point = {12.06643217585967, -8.887846315219841}},
                 kCrank}},
      // case 7 near-degenerate: five finite positions, crank step 1e-3 rad
      {.name = "IC08",
       .positions = {kShared1,
                     at("0.5812240245026311365482418258828878224897",
                        "0.3847411433330689292406289786030867716436",
                        "0.4718607026210954191906515164392647368953"),
                     at("0.5808945542010253008466392803487468856388",
                        "0.3857997967992419166769855589603426995249",
                        "0.4715270846665463675365105405092018591986"),
                     at("0.5805641824077778103194706189801237966127",
                        "0.386858081733913621076479257469990897526",
                        "0.4711935224762374537485122150678417942766"),
                     at("0.5802329094218246763163288380108624944415",
                        "0.3879159969842796653471855551106340585722",
                        "0.4708600166171328927125681008917109274283")},
       .dyads = {kCrank,
                 {.kind = DyadKind::crank,
                  .circle_point = {1.057023551861908, 18.95902873231336},
                  .centre_point = {6.734767173317724, -3.128513826229511}},
                 {.kind = DyadKind::crank,
                  .circle_point = {6.699896427002043, -1.8825930687512604},
                  .centre_point = {6.548903013582836, 1.6636106500688326}},
                 kRocker}},
      // case 7 near-degenerate: five finite positions, crank step 1e-6 rad
      {.name = "IC09",
       .positions = {kShared1,
                     at("0.5815522648964023757176671227839351535883",
                        "0.3836831816929242077986969485102583151871",
                        "0.4721940420713528825034391661539307122198"),
                     at("0.5815519367775316683196882349117718830267",
                        "0.3836842408965232383418083354273871804169",
                        "0.4721937083708755061852654671576983059668"),
                     at("0.581551608657758874077696513339812373429",
                        "0.3836853000997560428979737187344319344511",
                        "0.4721933746704527582991865857194346057415"),
                     at("0.5815512805370839932888513912834014448224",
                        "0.3836863593026226203124938464241598343701",
                        "0.4721930409700846394147497320918884193694")},
       .dyads = {kCrank,
                 {.kind = DyadKind::crank,
                  .circle_point = {1.1111540774826583, 18.788920622629284},
                  .centre_point = {6.71609488624357, -3.1176152891010833}},
                 {.kind = DyadKind::crank,
                  .circle_point = {6.680357822711736, -1.8725205295535479},
                  .centre_point = {6.536009988571666, 1.6640949098988096}},
                 kRocker}},
      // case 7 near-degenerate: five finite positions, crank step 1e-9 rad
      {.name = "IC10",
       .positions = {kShared1,
                     kShared4,
                     at("0.5815525923581359590171252405276856813254",
                        "0.3836821246073672484257053701933050524821",
                        "0.4721943751044837681575697395775969777593"),
                     at("0.5815525920300184391853194768209033655622",
                        "0.3836821256665713958775527528612171702545",
                        "0.4721943747707832089762158299844606824768"),
                     at("0.5815525917019009184514262756759667584084",
                        "0.3836821267257755429631764545197326002807",
                        "0.4721943744370826498494892150973612389371")},
       .dyads = {kCrank,
                 {.kind = DyadKind::crank,
                  .circle_point = {1.1112074864909922, 18.788752639506885},
                  .centre_point = {6.716076284723898, -3.117604350165939}},
                 {.kind = DyadKind::crank,
                  .circle_point = {6.680338384252358, -1.8725105674150269},
                  .centre_point = {6.5359971587081445, 1.6640953516770183}},
                 kRocker}},
      // case 7 approximating PP-PP-P, pair separation 1e-9 rad
      {.name = "IC13",
       .positions = {kShared1,
                     kShared4,
                     kShared2,
                     at("-0.669857796173648882603912972098639225667",
                        "1.089767515050749445047925383733511041625",
                        "0.1587043158108106626429795623160172106061"),
                     kShared3},
       .dyads = {kRocker,
                 {.kind = DyadKind::crank,
                  .circle_point = {8.372132407648905, 1.8041027273519779},
                  .centre_point = {6.557836429684739, 4.954499173512908}},
                 {.kind = DyadKind::crank,
                  .circle_point = {1.5117899591527233, 8.619847138471053},
                  .centre_point = {30.477920366165545, -32.944320585967965}},
                 kCrank}},
      // as 1e-6-step case but data given RELATIVE to position 0 (alpha0=beta0=gamma0=0), so small
      // numbers keep full relative accuracy
      {.name = "IC15",
       .positions = {at("0.0", "0.0", "0.0"),
                     at("0.0000001895572702681690034698133982547179850173",
                        "0.000001092539465022968664435925201239234067196",
                        "-0.0000003337005320041807202744498502611053989841"),
                     at("0.0000003791135705881826803358577894780671393331",
                        "0.000002185079014203016646045229288273254284934",
                        "-0.0000006674010093804988939734460826673584582434"),
                     at("0.0000005686689009597804663037452677036437043965",
                        "0.000003277618647538980440782191776598590547432",
                        "-0.00000100110143212838497285488434636758371473"),
                     at("0.0000007582232613827017980560837007745297027637",
                        "0.000004370158365029696544951517917799036130854",
                        "-0.000001334801800247269409708511892553955850865")},
       .dyads = {{.kind = DyadKind::crank,
                  .circle_point = {0.3, -0.2},
                  .centre_point = {-0.6924292551486645, -0.07718235662142461}},
                 {.kind = DyadKind::crank,
                  .circle_point = {1.1111540774826583, 18.788920622629284},
                  .centre_point = {3.8707178639645403, -5.908403839397801}},
                 {.kind = DyadKind::crank,
                  .circle_point = {6.680357822711736, -1.8725205295535479},
                  .centre_point = {5.885260092914112, -1.5680348913280648}},
                 {.kind = DyadKind::crank,
                  .circle_point = {3.5878044949658263, 1.0001423260940798},
                  .centre_point = {3.0972809183831607, -1.4512627038462094}}}},
  };
  return kTasks;
}

class PreciseDyads : public testing::TestWithParam<PreciseTask> {};

TEST_P(PreciseDyads, AreFoundWhereverTheirDigitsAre) {
  const BurmesterSolution solution = solve_burmester_precisely(GetParam().positions);

  EXPECT_EQ(solution.status, BurmesterStatus::solved);
  ASSERT_EQ(solution.dyads.size(), GetParam().dyads.size());
  EXPECT_GT(solution.digits, 12.0);
  for (const Dyad& expected : GetParam().dyads) {
    // 40 digits of positions a step of 1e-9 apart leave about four: 1e-40 by the fourth power.
    EXPECT_LT(nearest(solution.dyads, expected), GetParam().name == "IC10" ? 1e-3 : 1e-11);
  }
}

INSTANTIATE_TEST_SUITE_P(Burmester,
                         PreciseDyads,
                         testing::ValuesIn(precise_tasks()),
                         [](const auto& one) { return one.param.name; });

TEST(PreciseBurmester, IsNeededWhereDoublesRefuse) {
  for (const std::string name : {"IC09", "IC10", "IC15"}) {
    const auto task = std::ranges::find(precise_tasks(), name, &PreciseTask::name);
    std::vector<PositionJets> positions;
    for (const auto& position : task->positions) {
      positions.push_back(rounded(position));
    }

    EXPECT_EQ(solve_burmester(positions).status, BurmesterStatus::no_digits) << name;
  }
}

}  // namespace
}  // namespace kinestat
