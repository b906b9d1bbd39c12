package sunbeam.app.viewer;

import java.util.concurrent.CompletionException;
import java.util.concurrent.ExecutionException;
import jrtr.GraphicsException;
import sunbeam.app.cli.UsageException;
import sunbeam.app.input.InputException;
import sunbeam.app.mesh.MeshException;
import sunbeam.app.output.OutputException;
import sunbeam.precompute.json.JsonException;
import sunbeam.precompute.patch.PatchException;
import sunbeam.precompute.setting.SettingException;
import sunbeam.precompute.table.TableException;
import sunbeam.precompute.units.LengthFormatException;

/** Failures in one line. */
final class Problems {
    private Problems() {}

    static String message(Throwable thrown) {
        if ((thrown instanceof ExecutionException || thrown instanceof CompletionException)
                && thrown.getCause() != null) {
            return message(thrown.getCause());
        }
        if (thrown instanceof OutOfMemoryError) {
            return "out of memory: Java's heap may take "
                    + (Runtime.getRuntime().maxMemory() >> 20) + " MiB; allow more with SUNBEAM_JAVA_OPTIONS=-Xmx8g";
        }
        boolean known = thrown instanceof GraphicsException
                || thrown instanceof UsageException
                || thrown instanceof InputException
                || thrown instanceof MeshException
                || thrown instanceof OutputException
                || thrown instanceof PatchException
                || thrown instanceof TableException
                || thrown instanceof JsonException
                || thrown instanceof SettingException
                || thrown instanceof LengthFormatException
                || thrown instanceof IllegalArgumentException;
        return known && thrown.getMessage() != null
                ? thrown.getMessage()
                : "internal error, a bug in Sunbeam: " + thrown;
    }
}
