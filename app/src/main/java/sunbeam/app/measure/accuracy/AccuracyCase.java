package sunbeam.app.measure.accuracy;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.ParameterException;
import sunbeam.app.files.input.CsvTable;
import sunbeam.app.files.input.DirectionList;
import sunbeam.app.files.input.InputException;
import sunbeam.app.files.input.TextTable;
import sunbeam.app.terminal.options.MethodOptions;
import sunbeam.app.terminal.options.PatchOptions;
import sunbeam.precompute.method.FullMethod;
import sunbeam.precompute.patch.Patch;
import sunbeam.precompute.plan.MethodSettings;
import sunbeam.precompute.setting.SettingException;

/**
 * One case of a folder of cases: a surface, how it is lit, directions, and what is exact there.
 *
 * @param name of the case
 * @param patch the surface
 * @param options as at the command line, without a tolerance
 * @param directions with or without wavelengths
 * @param exact the columns of exact values by name, {@link #QUANTITIES}
 */
record AccuracyCase(String name, Patch patch, List<String> options, DirectionList directions, CsvTable exact) {
    /** Columns of exact values. */
    static final List<String> QUANTITIES =
            List.of("exact_power", "exact_power_ensemble", "exact_X", "exact_Y", "exact_Z");

    private static final String INDEX = "index.csv";
    private static final String DIRECTIONS = "in.csv";

    /** The options that a case may have, to be parsed as those of any command. */
    @Command(name = "index.csv")
    private static final class Options {
        @Mixin
        private PatchOptions patch;

        @Mixin
        private MethodOptions method = MethodOptions.of(FullMethod.TYPE);
    }

    /**
     * Reads all cases of a folder: {@code index.csv} names case, patch and options; {@code CASE/in.csv} has the directions
     * and the exact values.
     *
     * @throws InputException when one of the files cannot be used
     */
    static List<AccuracyCase> readAll(Path folder) {
        Path index = folder.resolve(INDEX);
        List<AccuracyCase> cases = new ArrayList<>();
        Set<String> taken = new HashSet<>();
        for (Map<String, String> row : TextTable.read(index, List.of("case", "patch", "options"))) {
            String name = row.get("case");
            if (!name.matches("[A-Za-z0-9_.-]+") || name.startsWith(".") || !taken.add(name)) {
                throw new InputException("cannot use " + index + ": the case '" + name
                        + "' is there twice or has no name of letters, digits, _ . -");
            }
            cases.add(read(folder.resolve(name), row.get("patch"), row.get("options")));
        }
        return cases;
    }

    private static AccuracyCase read(Path folder, String patch, String options) {
        List<String> words = Arrays.stream(options.split(" +"))
                .filter(word -> !word.isEmpty())
                .toList();
        Options parsed = parse(folder, words);
        Path directions = folder.resolve(DIRECTIONS);
        CsvTable exact = CsvTable.read(directions, List.of(), QUANTITIES);
        DirectionList list = DirectionList.read(directions);
        boolean power = exact.has("exact_power") || exact.has("exact_power_ensemble");
        boolean color = QUANTITIES.subList(2, 5).stream().allMatch(exact::has);
        if (list.spectral() ? !power : !color) {
            throw new InputException("cannot use " + directions + ": with the column wavelength it needs exact_power or"
                    + " exact_power_ensemble, without it exact_X,exact_Y,exact_Z");
        }
        String file = patch.endsWith(".json") ? folder.resolve(patch).toString() : patch;
        return new AccuracyCase(folder.getFileName().toString(), parsed.patch.load(file), words, list, exact);
    }

    private static Options parse(Path folder, List<String> words) {
        Options options = new Options();
        try {
            new CommandLine(options).parseArgs(words.toArray(String[]::new));
            options.method.choices();
        } catch (ParameterException | SettingException mistake) {
            throw new InputException("cannot use " + folder.resolveSibling(INDEX) + ", case " + folder.getFileName()
                    + ": " + mistake.getMessage());
        }
        return options;
    }

    /** What is asked for, at a tolerance. */
    FullMethod method(double tolerance) {
        return FullMethod.of(parse(Path.of(name), options).method.choices().with(MethodSettings.TOLERANCE, tolerance));
    }

    /** Whether the exact values are powers at single wavelengths; else colours. */
    boolean spectral() {
        return directions.spectral();
    }

    /** X, Y, Z of a row. */
    double[] exactXyz(int row) {
        return new double[] {exact.at(row, "exact_X"), exact.at(row, "exact_Y"), exact.at(row, "exact_Z")};
    }
}
