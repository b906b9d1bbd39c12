package sunbeam.app.cli.figures;

import java.nio.file.Files;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import sunbeam.precompute.text.Text;

/**
 * Measurement of a figure's pictures, and the rule by which the thesis's claim holds.
 *
 * @param of pictures to measure, each as patch, hyphen, name and, for a number, a JSON pointer
 * @param to picture to compare with; null for none
 * @param rule {@code ascending}, {@code descending}, or limits such as {@code < 1}: one for all values or one for each
 */
record Check(Measure measure, List<String> of, String to, String rule) {
    /** Least ratio of neighbors that ascend or descend: measured at 96 and 256 pixels, a value differs by less. */
    private static final double STEP = 1.05;

    record Verdict(boolean agrees, String numbers) {
        @Override
        public String toString() {
            return (agrees ? "agrees" : "differs") + ": " + numbers;
        }
    }

    Optional<Verdict> verdict(List<Figure.Drawing> drawings) {
        List<Figure.Drawing> measured =
                of.stream().flatMap(name -> find(drawings, name).stream()).toList();
        Optional<Figure.Drawing> base = to == null ? Optional.empty() : find(drawings, to);
        if (measured.size() < of.size() || (to != null && base.isEmpty())) {
            return Optional.empty();
        }
        double[] values = IntStream.range(0, of.size())
                .mapToDouble(i -> measure.of(measured.get(i), pointer(of.get(i)), base.orElse(null)))
                .toArray();
        if (Arrays.stream(values).anyMatch(Double::isNaN)) {
            return Optional.empty();
        }
        String numbers = IntStream.range(0, values.length)
                .mapToObj(i -> of.get(i).replaceFirst("/.*", "") + Text.format(" %.3g", values[i]))
                .collect(Collectors.joining(", "));
        String from = to == null ? "" : " from " + to;
        return Optional.of(new Verdict(holds(values), measure + from + ": " + numbers + " (" + rule + ")"));
    }

    private static Optional<Figure.Drawing> find(List<Figure.Drawing> drawings, String name) {
        String picture = name.replaceFirst("/.*", "");
        return drawings.stream()
                .filter(drawing -> drawing.name().equals(picture) && Files.isRegularFile(drawing.file()))
                .findFirst();
    }

    private static String pointer(String name) {
        return name.contains("/") ? name.substring(name.indexOf('/')) : "";
    }

    private boolean holds(double[] values) {
        String[] limits = rule.split(", ", -1);
        return IntStream.range(0, values.length).allMatch(i -> switch (rule) {
            case "ascending" -> i == 0 || values[i] > STEP * values[i - 1];
            case "descending" -> i == 0 || STEP * values[i] < values[i - 1];
            default -> isWithin(limits[limits.length == 1 ? 0 : i], values[i]);
        });
    }

    private static boolean isWithin(String limit, double value) {
        double number = Double.parseDouble(limit.substring(2));
        return limit.startsWith("<") ? value < number : value > number;
    }
}
