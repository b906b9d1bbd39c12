package jrtr.gl;

import com.jogamp.opengl.GL3;
import jrtr.Resource;

/** What all resources share: a device, a label, and an end. */
abstract class GlResource implements Resource {
    private final GlDevice device;
    private final String label;
    private boolean closed;

    /** Registers with the device, which frees it at the latest when it is closed itself. */
    GlResource(GlDevice device, String label) {
        this.device = device;
        this.label = label;
        device.register(this);
    }

    /** Deletes the OpenGL objects. Called once, with the context current. */
    abstract void delete(GL3 gl);

    final GlDevice device() {
        return device;
    }

    /** The functions, if this resource is still there. */
    final GL3 gl() {
        GL3 gl = device.gl();
        if (closed) {
            throw new IllegalStateException("'" + label + "' is closed");
        }
        return gl;
    }

    /** Throws unless this is open and belongs to the device that wants to use it. */
    final void requireUsableBy(GlDevice user) {
        if (user != device) {
            throw new IllegalStateException("'" + label + "' belongs to another render context");
        }
        if (closed) {
            throw new IllegalStateException("'" + label + "' is closed");
        }
    }

    @Override
    public final String label() {
        return label;
    }

    @Override
    public final boolean isClosed() {
        return closed;
    }

    @Override
    public final void close() {
        device.requireOwner();
        if (!closed) {
            closed = true;
            device.unregister(this);
            delete(device.gl());
        }
    }

    @Override
    public final String toString() {
        return getClass().getSimpleName() + " '" + label + "'" + (closed ? " (closed)" : "");
    }
}
