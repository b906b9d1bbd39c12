package jrtr.gl;

import com.jogamp.opengl.GL3;
import java.util.function.Consumer;

/**
 * Something that lives in the graphics memory of one {@link RenderContext}. Closing it twice, or after its context, does
 * nothing.
 */
public abstract class Resource implements AutoCloseable {
    private final GlDevice device;
    private final String label;
    private boolean closed;

    /** Registers with the device, which frees it at the latest when it is closed itself. */
    Resource(GlDevice device, String label) {
        this.device = device;
        this.label = label;
        device.register(this);
    }

    /** Does what makes a resource usable; closes it where that fails. */
    static <R extends Resource> R opened(R resource, Consumer<R> opening) {
        try {
            opening.accept(resource);
            return resource;
        } catch (RuntimeException failure) {
            resource.close();
            throw failure;
        }
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

    /** The name given at creation, for messages. */
    public final String label() {
        return label;
    }

    /**
     * Frees the memory.
     *
     * @throws IllegalStateException on any thread but the context's
     */
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
