package sunbeam.app.files.output;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;

@FunctionalInterface
public interface StreamContent {
    void writeTo(OutputStream stream) throws IOException;

    static StreamContent of(CharSequence text) {
        byte[] bytes = text.toString().getBytes(StandardCharsets.UTF_8);
        return stream -> stream.write(bytes);
    }
}
