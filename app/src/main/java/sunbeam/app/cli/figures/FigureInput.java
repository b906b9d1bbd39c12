package sunbeam.app.cli.figures;

import com.fasterxml.jackson.core.JsonPointer;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.DoubleNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.Map;
import sunbeam.app.files.output.AtomicFile;
import sunbeam.app.files.output.Overwrite;
import sunbeam.app.files.output.PngWriter;

/** Writes the files that a picture's command reads: its scene, and the patch of figures 4.5 and 4.6. */
final class FigureInput {
    static final String SCENE = ".scene.json";

    /** Image of one period with a ridge, whose share of the period is that of the thesis's slits: 30 of 150 um. */
    static final String SLITS = "slits.png";

    private static final int SLITS_SIDE = 50;

    /** Key of an angle in degrees by which the scene's light is turned counter-clockwise about the vertical. */
    private static final String TURN = "turn";

    private FigureInput() {}

    static void write(Figure.Drawing drawing, Path folder) {
        if (drawing.command().contains(folder.resolve(SLITS).toString())) {
            BufferedImage slits = new BufferedImage(SLITS_SIDE, SLITS_SIDE, BufferedImage.TYPE_BYTE_GRAY);
            Graphics2D graphics = slits.createGraphics();
            graphics.setColor(Color.WHITE);
            graphics.fillRect(2 * SLITS_SIDE / 5, 0, SLITS_SIDE / 5, SLITS_SIDE);
            graphics.dispose();
            PngWriter.write(folder.resolve(SLITS), Overwrite.REPLACE, slits, Map.of());
        }
        if (drawing.picture().scene() != null) {
            AtomicFile.write(
                    drawing.beside(SCENE),
                    Overwrite.REPLACE,
                    AtomicFile.StreamContent.of(scene(drawing.picture().scene())));
        }
    }

    private static String scene(Map<String, JsonNode> values) {
        Map<String, JsonNode> own = new LinkedHashMap<>(values);
        String resource = "/sunbeam/scenes/" + own.remove("scene").asText() + ".json";
        try (InputStream stream = FigureInput.class.getResourceAsStream(resource)) {
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
}
