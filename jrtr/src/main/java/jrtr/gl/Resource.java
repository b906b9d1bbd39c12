package jrtr.gl;

import com.jogamp.opengl.GL3;
import java.util.function.Consumer;

/** Object in the graphics memory of one {@link RenderContext}. Closing it again, or after its context, does nothing. */
public abstract class Resource implements AutoCloseable {
    private final GlDevice device;
    private final String label;
    private boolean closed;

    Resource(GlDevice device, String label) {
        this.device = device;
        this.label = label;
        device.register(this);
    }

    /** Initializes a resource; closes it if that fails. */
    static <R extends Resource> R initialize(R resource, Consumer<R> initialization) {
        try {
            initialization.accept(resource);
            return resource;
        } catch (RuntimeException failure) {
            resource.close();
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
        if (closed) {
            throw new IllegalStateException("'" + label + "' is closed");
        }
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

    /** Returns the name of this resource in messages, as given at creation. */
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
