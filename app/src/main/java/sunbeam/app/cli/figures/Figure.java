package sunbeam.app.cli.figures;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.UnaryOperator;
import java.util.stream.Stream;
import sunbeam.app.files.input.InputException;
import sunbeam.app.terminal.UsageException;
import sunbeam.precompute.text.Text;

/**
 * Figure or table of the thesis, as an entry of the manifest figures.json.
 *
 * @param number number in the thesis, such as 5.10 or table-4.1; "resolution" for a question that the thesis leaves open
 * @param verdict statement whether the thesis's result ({@code thesis}) and Sunbeam's ({@code ours}) agree, or why not
 * @param patches patches for which each picture is drawn: blaze, elaphe, xenopeltis; empty if the commands name their own
 * @param compared true if all maps of a patch use the exposure of its first map and are compared with it
 */
record Figure(
        String number,
        String title,
        String thesis,
        String ours,
        String verdict,
        List<String> patches,
        boolean compared,
        List<Picture> pictures) {

    /**
     * Picture to draw for each patch.
     *
     * @param label words for the caption that distinguish the picture from the others of the figure
     * @param command command line of this program. {patch}, {blaze}, {elaphe} and {xenopeltis} stand for patches, {file} for the picture,
     *     {stem} for its name without the ending; a command without any of them draws a map
     * @param picture file that the command writes, with {stem}; null for {stem}.png
     * @param numbers numbers of the thesis, by JSON pointers to Sunbeam's numbers in {stem}.json, with _nm where these are in meters
     *     (_m); null for none
     */
    record Picture(String name, String label, String command, String picture, Map<String, Double> numbers) {}

    /** Reads the manifest, in the thesis's order. */
    static List<Figure> all() {
        try (InputStream manifest = Figure.class.getResourceAsStream("figures.json")) {
            return List.of(new ObjectMapper().readValue(manifest, Figure[].class));
        } catch (IOException failure) {
            throw new UncheckedIOException(failure);
        }
    }

    /**
     * Returns the figures with these numbers; all if the list is empty.
     *
     * @throws UsageException for an unknown number
     */
    static List<Figure> select(List<String> numbers) {
        List<Figure> all = all();
        List<String> known = all.stream().map(Figure::number).toList();
        for (String number : numbers) {
            if (!known.contains(number)) {
                throw new UsageException(
                        "--only " + number + ": no such figure; choose from " + String.join(", ", known));
            }
        }
        return all.stream()
                .filter(figure -> numbers.isEmpty() || numbers.contains(figure.number()))
                .toList();
    }

    /** Returns "Figure 5.10: ..." or "Table 4.1: ...". */
    String heading() {
        boolean isFigure = Character.isDigit(number.charAt(0));
        String named = isFigure ? "figure " + number : number.replace('-', ' ');
        return Character.toUpperCase(named.charAt(0)) + named.substring(1) + ": " + title;
    }

    /** Picture of one patch, with the command line that draws it and the file of the picture to compare it with. */
    record Drawing(String number, String patch, Picture picture, Path file, List<String> command, Optional<Path> base) {
        /**
         * True if the command has {@code --resume}, so that it redraws an existing picture only if the parameters differ. An existing
         * picture of another command is kept as it is.
         */
        boolean resumes() {
            return command.get(0).equals("brdf-map")
                    || (command.get(0).equals("render") && !command.contains("--wireframe"));
        }

        /** True for plots and scenes, which are wider than maps. */
        boolean isWide() {
            return !command.get(0).equals("brdf-map");
        }

        /**
         * Returns rows of the picture's label, the number's name, the thesis's number, Sunbeam's and their difference, for all results that
         * exist.
         */
        List<List<String>> numbers() {
            Path ours = Path.of(file.toString().replaceFirst("\\.png$", ".json"));
            if (picture.numbers() == null || !Files.isRegularFile(ours)) {
                return List.of();
            }
            try {
                JsonNode tree = new ObjectMapper().readTree(ours.toFile());
                List<List<String>> rows = new ArrayList<>();
                picture.numbers().forEach((pointer, thesis) -> {
                    JsonNode value = tree.at(pointer.replaceFirst("_nm(2?)$", "_m$1"));
                    if (value.isNumber()) {
                        double unit = pointer.endsWith("_nm2") ? 1e18 : pointer.endsWith("_nm") ? 1e9 : 1;
                        double number = unit * value.asDouble();
                        rows.add(List.of(
                                picture.label(),
                                pointer.replaceFirst(".*/", "").replace('_', ' '),
                                Text.format("%.2f", thesis),
                                Text.format("%.2f", number),
                                Text.format("%+.2f", number - thesis)));
                    }
                });
                return rows;
            } catch (IOException failure) {
                throw InputException.of(ours, failure);
            }
        }
    }

    /** Returns the names of the patches, which have a row of pictures each; a single empty name if the commands name their own patches. */
    List<String> rows() {
        return patches.isEmpty() ? List.of("") : patches;
    }

    /**
     * @param source function from a patch to the argument of {@code --patch}
     * @param size side of maps, pixels
     */
    List<Drawing> drawings(UnaryOperator<String> source, int size, Path folder) {
        return rows().stream()
                .flatMap(patch -> pictures.stream().map(picture -> drawing(patch, picture, source, size, folder)))
                .toList();
    }

    private Drawing drawing(String patch, Picture picture, UnaryOperator<String> source, int size, Path folder) {
        String stem = folder.resolve(stem(patch, picture)).toString();
        String template = picture.picture() == null ? "{stem}.png" : picture.picture();
        Path file = Path.of(template.replace("{stem}", stem));
        if (picture.command().contains("{")) {
            List<String> words = Stream.of(picture.command().split(" ", -1))
                    .map(word -> expanded(word, patch, source, file, stem))
                    .toList();
            return new Drawing(number, patch, picture, file, words, Optional.empty());
        }
        // Method gem has no absolute brightness, so it has its own exposure.
        Optional<Path> base = Optional.of(folder.resolve(stem(patch, pictures.get(0)) + ".png"))
                .filter(first ->
                        compared && !first.equals(file) && !picture.command().contains("--method gem"));
        List<String> words = new ArrayList<>(List.of(picture.command().split(" ", -1)));
        words.addAll(List.of("--no-annotate", "--size", Integer.toString(size)));
        base.ifPresent(first -> words.addAll(List.of("--exposure", first.toString())));
        words.addAll(List.of("--patch", source.apply(patch), "--output", file.toString()));
        return new Drawing(number, patch, picture, file, words, base);
    }

    private static String expanded(String word, String patch, UnaryOperator<String> source, Path file, String stem) {
        String expanded = word.replace("{file}", file.toString()).replace("{stem}", stem);
        for (String name : List.of("patch", "blaze", "elaphe", "xenopeltis")) {
            if (expanded.contains("{" + name + "}")) {
                expanded = expanded.replace("{" + name + "}", source.apply(name.equals("patch") ? patch : name));
            }
        }
        return expanded;
    }

    private String stem(String patch, Picture picture) {
        return number + (patch.isEmpty() ? "-" : "-" + patch + "-") + picture.name();
    }
}
