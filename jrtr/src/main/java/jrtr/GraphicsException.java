package jrtr;

/** Graphics that cannot be had or used: no display, no OpenGL, a shader that does not compile; the message says which. */
public final class GraphicsException extends RuntimeException {
    public GraphicsException(String message) {
        super(message);
    }

    public GraphicsException(String message, Throwable cause) {
        super(message, cause);
    }
}
