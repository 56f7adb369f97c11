function figure7(picture, data)
% Draws Figure 7 from the tables in figures/data, and checks the coefficients in them; in MATLAB or Octave.
%
%   figure7                  in a window
%   figure7('fig07.svg')     into a file; the folder of the tables may follow
%
% figures/data/README.md says what the columns hold. c_SN and c_PD of each resonance are those of coefficients.csv. Beside them
% stands what the curve of Figure 7 says: the limit of (A - A_graz(omega)) / (omega - omega*)^2 as the impact velocity goes to 0,
% with the closed form of A_graz (eq:Agraz).
if nargin < 2
    data = fullfile(fileparts(mfilename('fullpath')), '..', '..', 'figures', 'data');
end
zeta = 0.02; % figures/parameters.toml
grazing = @(omega) hypot(1 - omega.^2, 2 * zeta * omega);
curves = read(fullfile(data, 'fig07_curves.csv'));
points = read(fullfile(data, 'fig07_points.csv'));
regions = read(fullfile(data, 'fig07_regions.csv'));
coefficients = read(fullfile(data, 'coefficients.csv'));

window = figure('visible', 'off');
hold on;
greys = struct('non_impacting', 0.91, 'mps', 0.7, 'both', 0.7, 'undecided', 0.5);
for kind = fieldnames(greys)'
    is = strcmp(strrep(regions.kind, '-', '_'), kind{1});
    for ring = unique([regions.region(is), regions.ring(is)], 'rows')'
        on = regions.region == ring(1) & regions.ring == ring(2);
        grey = max(greys.(kind{1}), ring(2) > 0); % rings other than 0 are holes
        patch(regions.amplitude(on), regions.omega(on), grey * [1 1 1], 'EdgeColor', 'none');
    end
end
colours = struct('graz', [120 200 110], 'SN', [25 70 190], 'PD', [214 47 32], 'GZ', [0 88 56], 'NS', [122 28 140]);
names = fieldnames(colours)';
names = names(ismember(names, curves.kind));
drawn = cell(1, numel(names));
for k = 1:numel(names)
    on = find(strcmp(curves.kind, names{k}) & strcmp(curves.admissible, 'true'));
    [arc, order] = sort(curves.arc(on));
    place = cumsum([1; 1 + (diff(arc) ~= 0)]); % a gap between arcs
    line = NaN(place(end), 2);
    line(place, :) = [curves.amplitude(on(order)), curves.omega(on(order))];
    width = 1 + 1.5 * strcmp(names{k}, 'graz');
    drawn{k} = plot(line(:, 1), line(:, 2), 'Color', colours.(names{k}) / 255, 'LineWidth', width);
end
is = strcmp(points.kind, 'resonance');
drawn{end + 1} = plot(points.amplitude(is), points.omega(is), 'k^', 'MarkerFaceColor', 'k', 'MarkerSize', 4);
drawn{end + 1} = plot(points.amplitude(~is), points.omega(~is), 'ko', 'MarkerFaceColor', 'k', 'MarkerSize', 3);
legend([drawn{:}], [names, {'resonance', 'codimension two'}], 'Location', 'eastoutside');
axis([0 1.3 0.35 1.02]);
set(gca, 'Box', 'on', 'Layer', 'top');
xlabel('A');
ylabel('\omega');
if nargin > 0
    [~, ~, ending] = fileparts(picture);
    print(window, picture, ['-d' ending(2:end)]);
    close(window);
else
    set(window, 'visible', 'on');
end

on = strcmp(curves.kind, 'graz');
distance = max(abs(curves.amplitude(on) - grazing(curves.omega(on))));
fprintf('grazing curve: %d points, at most %.1e from A_graz\n', sum(on), distance);
fprintf('%2s %2s  %-10s  %-12s  %-12s  %-12s  %-12s\n', 'p', 'n', 'omega*', 'c_SN', 'of curve', 'c_PD', 'of curve');
for k = 1:numel(coefficients.p)
    p = coefficients.p(k);
    star = coefficients.omega_star(k);
    fprintf('%2d %2d  %.8f', p, coefficients.n(k), star);
    for kind = {'SN', 'PD'}
        column = coefficients.(['c_' lower(kind{1})]);
        fprintf('  %-12.7g  %-12.7g', column(k), measured(curves, kind{1}, p, star, grazing));
    end
    fprintf('\n');
end
end

function value = measured(curves, kind, p, star, grazing)
% At the resonance: a cubic in the impact velocity through the four points that follow it on its curve; NaN without these.
begins = strcmp(curves.kind, kind) & curves.p == p & curves.impact_velocity == 0 & abs(curves.omega - star) < 1e-9;
value = NaN;
for first = find(begins)'
    on = find(curves.arc == curves.arc(first));
    [~, order] = sort(abs(on - first));
    on = on(order(2:5));
    quotient = (curves.amplitude(on) - grazing(curves.omega(on))) ./ (curves.omega(on) - star).^2;
    cubic = polyfit(curves.impact_velocity(on), quotient, 3);
    value = cubic(end);
end
end

function columns = read(file)
% The columns of a table by their names: numbers, NaN where there is none, or words.
lines = regexp(strtrim(fileread(file)), '\r?\n', 'split');
cells = regexp(lines, ',', 'split');
for k = 1:numel(cells{1})
    words = cellfun(@(row) row{k}, cells(2:end)', 'UniformOutput', false);
    numbers = str2double(words);
    if all(isnan(numbers))
        columns.(cells{1}{k}) = words;
    else
        columns.(cells{1}{k}) = numbers;
    end
end
end
