package sunbeam.app.cli.figures;

import java.nio.file.Files;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import sunbeam.precompute.text.Text;

/**
 * One statement of the thesis about a figure, and the rule by which measurements of its pictures hold it.
 *
 * @param claim the statement in a few words
 * @param of pictures to measure, each as patch, hyphen, name and, for a number, a JSON pointer
 * @param to picture to compare with, or one for each of {@code of}, separated by commas; null for none
 * @param rule {@code ascending} or {@code descending}, perhaps followed by {@code by} and a least step; {@code first lowest}; or limits such
 *     as {@code < 1}: one for all values, or one for each, separated by commas
 */
record Check(String claim, Measure measure, List<String> of, String to, String rule) {
    /** Least ratio of neighbors that ascend or descend: measured at 96 and 256 pixels, a value differs by less. */
    private static final double RATIO = 1.05;

    private static final String BY = " by ";

    /**
     * Result of all checks of a figure: one that fails decides, whatever is missing.
     *
     * @param agrees empty if no check fails, but a picture or a number is missing
     * @param measured claims and numbers, those that fail first
     * @param missing names of the numbers that no picture or report had
     */
    record Verdict(Optional<Boolean> agrees, String measured, List<String> missing) {
        static Verdict of(List<Check> checks, List<Figure.Drawing> drawings) {
            List<String> failed = new ArrayList<>();
            List<String> others = new ArrayList<>();
            List<String> missing = new ArrayList<>();
            for (Check check : checks) {
                double[] values = check.values(drawings);
                List<String> unknown = IntStream.range(0, values.length)
                        .filter(i -> Double.isNaN(values[i]))
                        .mapToObj(check.of::get)
                        .toList();
                boolean fails = check.fails(values);
                String state = fails ? " fails: " : unknown.isEmpty() ? " holds: " : " is open: ";
                (fails ? failed : others).add("'" + check.claim + "'" + state + check.text(values));
                missing.addAll(unknown);
            }
            Optional<Boolean> agrees =
                    !failed.isEmpty() ? Optional.of(false) : missing.isEmpty() ? Optional.of(true) : Optional.empty();
            failed.addAll(others);
            return new Verdict(
                    agrees,
                    String.join("; ", failed),
                    missing.stream().distinct().toList());
        }

        @Override
        public String toString() {
            String word = agrees.map(yes -> yes ? "agrees" : "differs").orElse("not decided");
            return word + ": " + measured + (missing.isEmpty() ? "" : "; missing: " + String.join(", ", missing));
        }
    }

    private double[] values(List<Figure.Drawing> drawings) {
        String[] bases = to == null ? new String[0] : to.split(", ", -1);
        return IntStream.range(0, of.size())
                .mapToDouble(i -> {
                    Optional<Figure.Drawing> picture = find(drawings, of.get(i));
                    if (to == null) {
                        return picture.map(drawing -> measure.of(drawing, pointer(i), null))
                                .orElse(Double.NaN);
                    }
                    Optional<Figure.Drawing> base = find(drawings, ofEach(bases, i));
                    return picture.flatMap(drawing -> base.map(other -> measure.of(drawing, pointer(i), other)))
                            .orElse(Double.NaN);
                })
                .toArray();
    }

    private static String ofEach(String[] words, int i) {
        return words[words.length == 1 ? 0 : i];
    }

    private static Optional<Figure.Drawing> find(List<Figure.Drawing> drawings, String name) {
        return drawings.stream()
                .filter(drawing -> drawing.name().equals(picture(name)) && Files.isRegularFile(drawing.file()))
                .findFirst();
    }

    private static String picture(String name) {
        return name.replaceFirst("/.*", "");
    }

    private String pointer(int i) {
        return of.get(i).substring(picture(of.get(i)).length());
    }

    /** True if numbers that exist break the rule; neighbors of a missing number are not compared. */
    boolean fails(double[] values) {
        String[] limits = rule.split(", ", -1);
        double step = rule.contains(BY) ? Double.parseDouble(rule.replaceFirst(".*" + BY, "")) : Double.NaN;
        return IntStream.range(0, values.length).anyMatch(i -> switch (rule.replaceFirst(BY + ".*", "")) {
            case "ascending" -> i > 0 && isNotAbove(values[i], values[i - 1], step);
            case "descending" -> i > 0 && isNotAbove(values[i - 1], values[i], step);
            case "first lowest" -> i > 0 && isNotAbove(values[i], values[0], step);
            default -> isOutside(ofEach(limits, i), values[i]);
        });
    }

    private static boolean isNotAbove(double value, double other, double step) {
        return Double.isNaN(step) ? value <= RATIO * other : value - other <= step;
    }

    private static boolean isOutside(String limit, double value) {
        double number = Double.parseDouble(limit.substring(2));
        return limit.startsWith("<") ? value >= number : value <= number;
    }

    private String text(double[] values) {
        String numbers = IntStream.range(0, values.length)
                .filter(i -> !Double.isNaN(values[i]))
                .mapToObj(i -> picture(of.get(i)) + Text.format(" %.3g", values[i]))
                .collect(Collectors.joining(", "));
        String from = to == null ? "" : " from " + to;
        return measure + from + ": " + (numbers.isEmpty() ? "none" : numbers) + " (" + rule + ")";
    }
}
