package sunbeam.app.render;

import jrtr.gl.FloatTarget;
import jrtr.gl.RenderContext;

/** A render target of one image that is reused while its size stays the same. */
final class CachedTarget implements AutoCloseable {
    private final RenderContext context;
    private final String label;
    private final FloatTarget.Format format;
    private final boolean depth;
    private FloatTarget target;

    CachedTarget(RenderContext context, String label, FloatTarget.Format format, boolean depth) {
        this.context = context;
        this.label = label;
        this.format = format;
        this.depth = depth;
    }

    /** Valid until a call with another size. Contains the last draw, if any. */
    FloatTarget of(int width, int height) {
        FloatTarget.Spec spec = new FloatTarget.Spec(width, height, 1, depth, format);
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
