package sunbeam.app.gpu.picture;

import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import picocli.CommandLine.Option;
import sunbeam.app.files.input.InputException;
import sunbeam.app.files.input.PngText;
import sunbeam.app.terminal.UsageException;
import sunbeam.precompute.units.Decimals;

/** {@code --exposure} of commands that may draw several pictures alike; to be used as a picocli mixin. */
public final class ExposureOption {
    private static final String AUTOMATIC = "auto";
    private static final String FIRST = "first";

    @Option(
            names = "--exposure",
            paramLabel = "FACTOR",
            defaultValue = AUTOMATIC,
            description = "Factor for the linear colours; auto (default): chosen from the pictures, one for all; first:"
                    + " chosen from the first; or a picture FILE.png whose exposure is to be taken.")
    private String exposure;

    /** What was asked for, checked before anything is computed; reads the picture that is named. */
    public Exposure parse() {
        if (isOfAll()) {
            return AutoExposure::of;
        }
        if (isOfFirst()) {
            return pictures -> AutoExposure.of(pictures[0]);
        }
        if (exposure.toLowerCase(Locale.ROOT).endsWith(".png")) {
            double recorded = recorded();
            return pictures -> recorded;
        }
        double value = Decimals.parse(exposure).orElse(Double.NaN);
        if (!(value > 0)) {
            throw new UsageException("--exposure '" + exposure
                    + "' is neither auto nor a positive number, nor first, nor a picture (.png) to take it from"
                    + Decimals.commaRemedy(exposure));
        }
        return pictures -> value;
    }

    /** Whether the factor is chosen from pictures. */
    public boolean isAutomatic() {
        return isOfAll() || isOfFirst();
    }

    /** Whether the factor is chosen from all pictures. */
    public boolean isOfAll() {
        return exposure.equalsIgnoreCase(AUTOMATIC);
    }

    private boolean isOfFirst() {
        return exposure.equalsIgnoreCase(FIRST);
    }

    private double recorded() {
        String text = PngText.read(Path.of(exposure)).getOrDefault("Exposure", "");
        double value = Decimals.parse(text).orElse(Double.NaN);
        if (!(value > 0)) {
            throw new InputException("cannot take the exposure of " + exposure
                    + ": it has no text 'Exposure' with a number above 0; name a picture that Sunbeam has written");
        }
        return value;
    }

    /** An exposure before the pictures are known. */
    @FunctionalInterface
    public interface Exposure {
        /** The factor for pictures that are to be drawn alike. */
        double of(LinearPicture... pictures);

        /** The factor for pictures that are to be drawn alike. */
        default double of(List<LinearPicture> pictures) {
            return of(pictures.toArray(LinearPicture[]::new));
        }
    }
}
