package sunbeam.app.scene.mesh;

import sunbeam.precompute.text.Quoted;

/** A mesh that cannot be used; the message, always one line, names the file, the line, the value and the remedy. */
public final class MeshException extends RuntimeException {
    /** @param message control characters are replaced */
    public MeshException(String message) {
        super(Quoted.oneLine(message));
    }

    /** @param message control characters are replaced */
    public MeshException(String message, Throwable cause) {
        super(Quoted.oneLine(message), cause);
    }
}
