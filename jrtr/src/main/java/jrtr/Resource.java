package jrtr;

/**
 * Something that lives in the graphics memory of one {@link RenderContext}. Closing it twice, or after its context, does
 * nothing.
 */
public interface Resource extends AutoCloseable {

    /** The name given at creation, for messages. */
    String label();

    /** Whether this or its context has been closed; every other use is then an {@link IllegalStateException}. */
    boolean isClosed();

    /**
     * Frees the memory.
     *
     * @throws IllegalStateException on any thread but the context's
     */
    @Override
    void close();
}
