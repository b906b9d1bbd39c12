package sunbeam.app.cli.figures;

import com.fasterxml.jackson.core.JsonPointer;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.DoubleNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import com.fasterxml.jackson.databind.node.TextNode;
import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.UnaryOperator;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import sunbeam.app.files.output.AtomicFile;
import sunbeam.app.files.output.Overwrite;
import sunbeam.app.files.output.PngWriter;
import sunbeam.app.files.output.StreamContent;
import sunbeam.app.terminal.UsageException;
import sunbeam.precompute.text.Text;

/**
 * Figure or table of the thesis, as an entry of the manifest figures.json.
 *
 * @param number number in the thesis, such as 5.10 or table-4.1
 * @param thesis what the thesis shows or claims
 * @param ours what Sunbeam's pictures show beside or instead of that
 * @param checks what the thesis says of the figure, and rules for it, stated before the pictures were measured
 * @param patches patches for which each picture is drawn: blaze, elaphe, xenopeltis; null if the commands name their own
 * @param compared true if all maps of a patch use the exposure of its first map and are compared with it
 */
record Figure(
        String number,
        String title,
        String thesis,
        String ours,
        List<Check> checks,
        List<String> patches,
        boolean compared,
        List<Picture> pictures) {
    private static final String SCENE = ".scene.json";
    // Image of one period with a ridge, whose share of the period is that of the thesis's slits: 30 of 150 um.
    private static final String SLITS = "slits.png";
    private static final int SLITS_SIDE = 50;
    private static final Pattern NAME = Pattern.compile("\\{(\\w+)\\}");
    // Key of an angle in degrees by which the scene's light is turned counter-clockwise about the vertical.
    private static final String TURN = "turn";
    /**
     * Picture to draw for each patch; optional values are null.
     *
     * @param label words for the caption that distinguish the picture from the others of the figure
     * @param command command line of this program. {blaze}, {elaphe} and {xenopeltis} stand for patches, {file} for the picture,
     *     {stem} for its name without the ending, {scene} for the scene's file, {size} for its size, {wavelengths} for those of a response,
     *     {slits} for {@link #SLITS}, {window} for a width whose orders are broader than pixels. A brdf-map without {file} draws
     *     a disc of the chosen size
     * @param plot {@link FigurePlot} in place of a command
     * @param picture file that the command writes, with {stem}; null for {stem}.png
     * @param scene built-in scene by the key "scene", and values that replace its own, by JSON pointers
     * @param hidden true for a picture that only the check or a plot needs
     * @param numbers numbers of the thesis, by JSON pointers to Sunbeam's numbers in {stem}.json, with _nm where these are in meters (_m)
     */
    record Picture(
            String name,
            String label,
            String command,
            FigurePlot plot,
            String picture,
            Map<String, JsonNode> scene,
            boolean hidden,
            Map<String, Double> numbers) {}

    static List<Figure> all() {
        try (InputStream manifest = Figure.class.getResourceAsStream("figures.json")) {
            ObjectMapper mapper = new ObjectMapper();
            JsonNode tree = mapper.readTree(manifest);
            for (JsonNode figure : tree) {
                expand(mapper, (ObjectNode) figure);
            }
            return List.of(mapper.treeToValue(tree, Figure[].class));
        } catch (IOException failure) {
            throw new UncheckedIOException(failure);
        }
    }

    /** Replaces each picture with {@code values} by one picture for each of them, in which the value stands for {}. */
    private static void expand(ObjectMapper mapper, ObjectNode figure) throws IOException {
        ArrayNode expanded = mapper.createArrayNode();
        for (JsonNode picture : figure.get("pictures")) {
            JsonNode values = ((ObjectNode) picture).remove("values");
            for (JsonNode value : values == null ? List.<JsonNode>of(new TextNode("")) : values) {
                expanded.add(mapper.readTree(picture.toString().replace("{}", value.asText())));
            }
        }
        figure.set("pictures", expanded);
    }

    static List<Figure> select(List<String> numbers) {
        List<Figure> all = all();
        List<String> known = all.stream().map(Figure::number).toList();
        numbers.forEach(number -> UsageException.throwIf(
                !known.contains(number),
                "--only " + number + ": no such figure; choose from " + String.join(", ", known)));
        return all.stream()
                .filter(figure -> numbers.isEmpty() || numbers.contains(figure.number()))
                .toList();
    }

    Check.Verdict verdict(List<Drawing> drawings) {
        return Check.Verdict.of(checks, drawings);
    }

    String heading() {
        String named = Character.isDigit(number.charAt(0)) ? "figure " + number : number.replace('-', ' ');
        return Character.toUpperCase(named.charAt(0)) + named.substring(1) + ": " + title;
    }

    record Drawing(Figure figure, String patch, Picture picture, Path file, List<String> command, Optional<Path> base) {
        /** True if the command has {@code --resume}: it redraws an existing picture only if the parameters differ. Others are kept. */
        boolean resumes() {
            return picture.plot() == null
                    && (command.get(0).equals("brdf-map")
                            || (command.get(0).equals("render") && !command.contains("--wireframe")));
        }

        /** Returns the picture's name in checks: patch, hyphen, name. */
        String name() {
            return (patch.isEmpty() ? "" : patch + "-") + picture.name();
        }

        Path beside(String ending) {
            return Path.of(file.toString().replaceFirst("\\.png$", ending));
        }

        /** Writes the files that the command reads: its scene, and the patch of figures 4.5 and 4.6. */
        void writeInput(Path folder) {
            if (command.contains(folder.resolve(SLITS).toString())) {
                BufferedImage slits = new BufferedImage(SLITS_SIDE, SLITS_SIDE, BufferedImage.TYPE_BYTE_GRAY);
                Graphics2D graphics = slits.createGraphics();
                graphics.setColor(Color.WHITE);
                graphics.fillRect(2 * SLITS_SIDE / 5, 0, SLITS_SIDE / 5, SLITS_SIDE);
                graphics.dispose();
                PngWriter.write(folder.resolve(SLITS), Overwrite.REPLACE, slits, Map.of());
            }
            if (picture.scene() != null) {
                AtomicFile.write(beside(SCENE), Overwrite.REPLACE, StreamContent.of(scene(picture.scene())));
            }
        }

        private static String scene(Map<String, JsonNode> values) {
            Map<String, JsonNode> own = new LinkedHashMap<>(values);
            String resource = "/sunbeam/scenes/" + own.remove("scene").asText() + ".json";
            try (InputStream stream = Figure.class.getResourceAsStream(resource)) {
                JsonNode scene = new ObjectMapper().readTree(stream);
                turn(
                        (ArrayNode) scene.at("/light/direction"),
                        own.containsKey(TURN) ? own.remove(TURN).asDouble() : 0);
                own.forEach((key, value) -> {
                    JsonPointer pointer = JsonPointer.compile(key);
                    ((ObjectNode) scene.at(pointer.head())).set(pointer.last().getMatchingProperty(), value);
                });
                return scene.toPrettyString();
            } catch (IOException failure) {
                throw new UncheckedIOException("cannot read " + resource, failure);
            }
        }

        private static void turn(ArrayNode direction, double degrees) {
            double cosine = Math.cos(Math.toRadians(degrees));
            double sine = Math.sin(Math.toRadians(degrees));
            double x = direction.get(0).asDouble();
            double y = direction.get(1).asDouble();
            direction.set(0, new DoubleNode(cosine * x - sine * y));
            direction.set(1, new DoubleNode(sine * x + cosine * y));
        }

        /** Returns rows of label, the number's name, the thesis's number, Sunbeam's and their difference, for all results that exist. */
        List<List<String>> numbers() {
            if (picture.numbers() == null || !Files.isRegularFile(beside(".json"))) {
                return List.of();
            }
            List<List<String>> rows = new ArrayList<>();
            picture.numbers().forEach((pointer, thesis) -> {
                double number = Measure.number(this, pointer);
                if (!Double.isNaN(number)) {
                    rows.add(List.of(
                            picture.label(),
                            pointer.replaceFirst(".*/", "").replace('_', ' '),
                            Text.format("%.2f", thesis),
                            Text.format("%.2f", number),
                            Text.format("%+.2f", number - thesis)));
                }
            });
            return rows;
        }
    }

    /** Returns the names of the patches, which have a row of pictures each; a single empty name if the commands name their own. */
    List<String> rows() {
        return patches == null ? List.of("") : patches;
    }

    List<Drawing> drawings(UnaryOperator<String> source, Sizes sizes, Path folder) {
        return rows().stream()
                .flatMap(patch -> pictures.stream().map(picture -> drawing(patch, picture, source, sizes, folder)))
                .toList();
    }

    record Sizes(int map, String scene, String wavelengths) {}

    private Drawing drawing(String patch, Picture picture, UnaryOperator<String> source, Sizes sizes, Path folder) {
        String stem = folder.resolve(stem(patch, picture)).toString();
        String template = picture.picture() == null ? "{stem}.png" : picture.picture();
        Path file = Path.of(template.replace("{stem}", stem));
        if (picture.plot() != null) {
            return new Drawing(this, patch, picture, file, List.of(), Optional.empty());
        }
        UnaryOperator<String> values = name -> switch (name) {
            case "file" -> file.toString();
            case "stem" -> stem;
            case "size" -> sizes.scene();
            case "wavelengths" -> sizes.wavelengths();
            case "window" -> patch.equals("blaze") ? "16um" : "65um";
            case "scene" -> stem + SCENE;
            case "slits" -> folder.resolve(SLITS).toString();
            default -> source.apply(name);
        };
        List<String> words = new ArrayList<>();
        for (String word : picture.command().split(" ", -1)) {
            words.add(NAME.matcher(word).replaceAll(name -> Matcher.quoteReplacement(values.apply(name.group(1)))));
        }
        if (!picture.command().startsWith("brdf-map") || picture.command().contains("{file}")) {
            return new Drawing(this, patch, picture, file, words, Optional.empty());
        }
        // Method gem has no absolute brightness, so it has its own exposure.
        Optional<Path> base = Optional.of(folder.resolve(stem(patch, pictures.get(0)) + ".png"))
                .filter(first ->
                        compared && !first.equals(file) && !picture.command().contains("--method gem"));
        words.addAll(List.of("--no-annotate", "--size", Integer.toString(sizes.map())));
        base.ifPresent(first -> words.addAll(List.of("--exposure", first.toString())));
        words.addAll(List.of("--patch", source.apply(patch), "--output", file.toString()));
        return new Drawing(this, patch, picture, file, words, base);
    }

    private String stem(String patch, Picture picture) {
        return number + (patch.isEmpty() ? "-" : "-" + patch + "-") + picture.name();
    }
}
