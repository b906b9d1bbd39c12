package sunbeam.app.render;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.stream.IntStream;
import jrtr.Tile;
import jrtr.gl.RenderContext;
import sunbeam.app.scene.Scene;

/** Draws whole pictures. */
public final class WholePicture {
    private WholePicture() {}

    public static ScenePicture of(SceneSession session, int width, int height) {
        ScenePicture picture = ScenePicture.empty(width, height);
        for (DrawRequest part : SceneSession.parts(session.scene(), width, height, PixelSamples.uniform(1))) {
            picture.put(session.draw(part), part.tile().x(), part.tile().y());
        }
        return picture;
    }

    /** Draws the sum of a scene's parts. */
    static ScenePicture ofParts(RenderContext context, List<SceneData> parts, int width, int height) {
        List<SceneSession> sessions = new ArrayList<>();
        try {
            parts.forEach(part -> sessions.add(new SceneSession(context, part)));
            Scene scene = parts.get(0).scene();
            PartSum sum = new PartSum(sessions);
            return sum.draw(
                    DrawRequest.ofPixels(scene, width, height, Tile.whole(width, height), PixelSamples.uniform(1)));
        } finally {
            sessions.forEach(SceneSession::close);
        }
    }

    /** Returns the indices of pixels, the brightest first. */
    static int[] byLuminance(float[] rgba) {
        return IntStream.range(0, rgba.length / 4)
                .boxed()
                .sorted(Comparator.comparingDouble(i -> -rgba[4 * i + 1]))
                .mapToInt(Integer::intValue)
                .toArray();
    }
}
