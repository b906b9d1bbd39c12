package sunbeam.app.render;

import jrtr.gl.FloatTarget;
import jrtr.gl.RenderContext;

/** A render target that is reused while its size and format stay the same. */
final class CachedTarget implements AutoCloseable {
    private FloatTarget target;

    /** Valid until a call with another size or format. Contains the last draw, if any. */
    FloatTarget of(RenderContext context, String label, FloatTarget.Spec spec) {
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
