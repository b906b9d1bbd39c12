package sunbeam.app.cli.render;

import java.awt.image.BufferedImage;
import picocli.CommandLine.Option;
import sunbeam.app.render.LineDrawings;
import sunbeam.app.render.LineDrawings.LightCone;
import sunbeam.app.render.SceneSession;
import sunbeam.app.scene.Scene;

/** Options {@code --light-cone} and {@code --strokes}, drawings over a picture; a picocli mixin. */
public final class Overlays {
    @Option(
            names = "--light-cone",
            description = "Also draw a cone from the middle of the picture towards the light, as the viewer does.")
    private boolean lightCone;

    @Option(
            names = "--strokes",
            description =
                    "Also draw the direction of the nanostructure: dots on the skin, each with a stroke along the patch's x axis. With --wireframe, strokes along the vertices' normals.")
    private boolean strokes;

    boolean hasLight() {
        return lightCone;
    }

    boolean hasStrokes() {
        return strokes;
    }

    /** Returns words for the picture's identity, by which {@code --resume} recognizes it. */
    String describe() {
        return (lightCone ? ", cone" : "") + (strokes ? ", strokes" : "");
    }

    void paint(BufferedImage image, Scene scene, SceneSession session) {
        if (strokes) {
            session.update(scene);
            LineDrawings.strokes(image.createGraphics(), session, image.getWidth(), image.getHeight());
        }
        if (lightCone) {
            LightCone.of(scene).paint(image.createGraphics(), image.getWidth(), image.getHeight());
        }
    }
}
