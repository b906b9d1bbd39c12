package sunbeam.app.gpu;

import jrtr.FloatTargetSpec;
import jrtr.gl.FloatTarget;
import jrtr.gl.RenderContext;

/** A target of one image that is kept for as long as the same size is asked for. */
public final class KeptTarget implements AutoCloseable {
    private final RenderContext context;
    private final String label;
    private final FloatTargetSpec.Format format;
    private final boolean depth;
    private FloatTarget target;

    /**
     * None is there before it is asked for.
     *
     * @param label its name in messages
     * @param depth whether it has depth
     */
    public KeptTarget(RenderContext context, String label, FloatTargetSpec.Format format, boolean depth) {
        this.context = context;
        this.label = label;
        this.format = format;
        this.depth = depth;
    }

    /** The target; valid until another size is asked for. Its contents are those of the last draw, if any. */
    public FloatTarget of(int width, int height) {
        FloatTargetSpec spec = new FloatTargetSpec(width, height, 1, depth, format);
        if (target == null || !target.spec().equals(spec)) {
            close();
            target = context.createFloatTarget(label, spec);
        }
        return target;
    }

    @Override
    public void close() {
        if (target != null) {
            target.close();
            target = null;
        }
    }
}
