package sunbeam.app.commands.figures;

import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.UnaryOperator;
import sunbeam.app.terminal.UsageException;

/**
 * One of the thesis's figures, an entry of the manifest figures.json.
 *
 * @param number in the thesis, for example 5.10
 * @param title what it shows
 * @param text what to see in it
 * @param patches of which each picture is drawn: blaze, elaphe, xenopeltis
 * @param compared whether all pictures of a patch take the exposure of its first and are compared with it
 * @param pictures in order
 */
record Figure(
        String number, String title, String text, List<String> patches, boolean compared, List<Picture> pictures) {

    /**
     * What is drawn of each patch.
     *
     * @param name within the figure
     * @param label what sets it apart from its neighbors
     * @param command of this program that draws it, without patch and output
     */
    record Picture(String name, String label, String command) {}

    /** The manifest, in the thesis's order. */
    static List<Figure> all() {
        try (InputStream manifest = Figure.class.getResourceAsStream("figures.json")) {
            return List.of(new ObjectMapper().readValue(manifest, Figure[].class));
        } catch (IOException failure) {
            throw new UncheckedIOException(failure);
        }
    }

    /**
     * The figures with these numbers; all where there are none.
     *
     * @throws UsageException for a number that is none of a figure
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

    /**
     * A picture of one patch.
     *
     * @param label for people
     * @param file where it goes
     * @param command line that draws it
     * @param base the picture that it is compared with
     */
    record Drawing(String number, String patch, String label, Path file, List<String> command, Optional<Path> base) {
        /** Maps know by themselves whether they are there, drawn alike; evaluations are kept where they are there. */
        boolean isMap() {
            return command.get(0).equals("brdf-map");
        }
    }

    /**
     * All pictures of the figure.
     *
     * @param source the argument of {@code --patch} that stands for a patch
     * @param size of maps, pixels
     */
    List<Drawing> drawings(UnaryOperator<String> source, int size, Path folder) {
        return patches.stream()
                .flatMap(patch ->
                        pictures.stream().map(picture -> drawing(patch, picture, source.apply(patch), size, folder)))
                .toList();
    }

    private Drawing drawing(String patch, Picture picture, String source, int size, Path folder) {
        Path file = folder.resolve(file(patch, picture));
        // Method gem knows no brightness and has an exposure of its own.
        Optional<Path> base = Optional.of(folder.resolve(file(patch, pictures.get(0))))
                .filter(first ->
                        compared && !first.equals(file) && !picture.command().contains("--method gem"));
        List<String> words = new ArrayList<>(List.of(picture.command().split(" ", -1)));
        if (words.get(0).equals("brdf-map")) {
            words.addAll(List.of("--no-annotate", "--size", Integer.toString(size)));
        }
        base.ifPresent(first -> words.addAll(List.of("--exposure", first.toString())));
        words.addAll(List.of("--patch", source, "--output", file.toString()));
        return new Drawing(number, patch, picture.label(), file, words, base);
    }

    private String file(String patch, Picture picture) {
        return number + "-" + patch + "-" + picture.name() + ".png";
    }
}
