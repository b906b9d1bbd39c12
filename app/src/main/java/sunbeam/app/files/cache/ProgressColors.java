package sunbeam.app.files.cache;

import java.util.function.Function;
import java.util.function.LongConsumer;
import sunbeam.app.terminal.progress.Progress;
import sunbeam.precompute.colortable.ColorColumns;
import sunbeam.precompute.colortable.ColorSource;

/** Colors that tell of their progress until they are closed. */
record ProgressColors(ColorSource colors, Progress progress) implements ColorSource {

    /**
     * Opens colors.
     *
     * @param label whose colors
     * @param places that will be asked for in all
     */
    static ProgressColors of(String label, Function<LongConsumer, ColorSource> source, long places) {
        Progress progress = Progress.start(label, places);
        try {
            return new ProgressColors(source.apply(progress::step), progress);
        } catch (RuntimeException | OutOfMemoryError failure) {
            progress.close();
            throw failure;
        }
    }

    @Override
    public float[] xyz(float[] places) {
        return colors.xyz(places);
    }

    @Override
    public float[] exact(float[] places) {
        return colors.exact(places);
    }

    @Override
    public void evaluate(ColorColumns columns) {
        colors.evaluate(columns);
    }

    @Override
    public void close() {
        progress.close();
        colors.close();
    }
}
