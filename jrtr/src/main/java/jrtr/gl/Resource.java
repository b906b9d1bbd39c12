package jrtr.gl;

import com.jogamp.opengl.GL3;
import java.util.function.Supplier;

/** Object in the graphics memory of one {@link RenderContext}. Closing it again, or after its context, does nothing. */
public abstract class Resource implements AutoCloseable {
    private final GlDevice device;
    private final String label;
    private boolean closed;

    Resource(GlDevice device, String label) {
        this.device = device;
        this.label = label;
        // Requires an open device and its thread.
        device.gl();
        device.resources().add(this);
    }

    /** Opens a resource; if that fails, closes others in the given order. */
    public static <T> T orClose(Supplier<T> opening, Runnable... others) {
        try {
            return opening.get();
        } catch (RuntimeException | Error failure) {
            for (Runnable other : others) {
                other.run();
            }
            throw failure;
        }
    }

    /** Called once, with the context current. */
    abstract void delete(GL3 gl);

    final GlDevice device() {
        return device;
    }

    final GL3 gl() {
        GL3 gl = device.gl();
        requireUsableBy(device);
        return gl;
    }

    final void requireUsableBy(GlDevice user) {
        if (user != device) {
            throw new IllegalStateException("'" + label + "' belongs to another render context");
        }
        if (closed) {
            throw new IllegalStateException("'" + label + "' is closed");
        }
    }

    /** Returns the name in messages. */
    public final String label() {
        return label;
    }

    /** Throws IllegalStateException on any thread but the context's. */
    @Override
    public final void close() {
        device.requireOwner();
        if (!closed) {
            closed = true;
            device.resources().remove(this);
            delete(device.gl());
        }
    }
}
