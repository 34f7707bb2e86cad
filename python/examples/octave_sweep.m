% The program kinestat called from GNU Octave (7 or newer): a report as a struct, and a
% sweep as vectors. It needs no library. The program is the one in the path, or what the environment
% variable KINESTAT_PROGRAM names:
%
%   octave-cli octave_sweep.m
1;  % a script, though it begins with a function

function text = kinestat (arguments)
  program = getenv ('KINESTAT_PROGRAM');
  if isempty (program)
    program = 'kinestat';
  end
  said = tempname ();  % messages apart from the answer
  [status, text] = system (sprintf ('"%s" %s 2> "%s"', program, arguments, said));
  messages = fileread (said);
  delete (said);
  if status ~= 0
    error ('kinestat, exit status %d\n%s', status, messages);
  end
end

folder = fullfile (fileparts (mfilename ('fullpath')), '..', '..', 'mechanisms');

% A report. Names of cases and couplings become names of fields: 'crank turns' is crankTurns.
file = fullfile (folder, 'transmissions', 'ravigneaux.yaml');
report = jsondecode (kinestat (sprintf ('analyze --format json "%s"', file)));
fprintf ('ratios: %.4f %.4f %.4f %.4f\n', report.cases.M1.ratio, report.cases.M2.ratio, ...
         report.cases.M3.ratio, report.cases.MR.ratio);

% A sweep. It is CSV with a line of titles; what has no value is empty, which becomes NaN.
file = fullfile (folder, 'sweeps', 'four_bar_height.yaml');
lines = strsplit (strtrim (kinestat (sprintf ('sweep --quiet "%s"', file))), char (10));
titles = strsplit (lines{1}, ',');
rows = cellfun (@(line) strsplit (line, ',', 'CollapseDelimiters', false), lines(2:end), ...
                'UniformOutput', false);
rows = vertcat (rows{:});
column = @(title) str2double (rows(:, strcmp (titles, title)));

height = column ('height [m]');
ratio = column ('ratio');
closed_form = (6 * height - 3) ./ (18 - height);  % by the pole of crank and rocker
fprintf ('%d rows, ratio from %.4f to %.4f, off the closed form by less than %g\n', ...
         numel (ratio), min (ratio), max (ratio), 10 ^ ceil (log10 (max (abs (ratio - closed_form)))));
