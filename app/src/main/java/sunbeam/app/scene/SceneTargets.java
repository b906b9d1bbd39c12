package sunbeam.app.scene;

import java.util.HashMap;
import java.util.Map;
import jrtr.FloatTarget;
import jrtr.FloatTargetSpec;
import jrtr.RenderContext;
import jrtr.Tile;

/** Render targets as large as a picture's blocks, of which there are four sizes at most; kept for one picture size. */
final class SceneTargets implements AutoCloseable {
    private final RenderContext context;
    private final Map<FloatTargetSpec, FloatTarget> targets = new HashMap<>();
    private int width;
    private int height;

    SceneTargets(RenderContext context) {
        this.context = context;
    }

    /** The target for a block of a picture. */
    FloatTarget of(int pictureWidth, int pictureHeight, Tile block) {
        if (pictureWidth != width || pictureHeight != height) {
            close();
            width = pictureWidth;
            height = pictureHeight;
        }
        return targets.computeIfAbsent(
                FloatTargetSpec.colorAndDepth(block.width(), block.height()),
                spec -> context.createFloatTarget("scene block", spec));
    }

    @Override
    public void close() {
        targets.values().forEach(FloatTarget::close);
        targets.clear();
    }
}
