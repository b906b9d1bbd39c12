package sunbeam.app.cli;

import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.ToDoubleFunction;
import picocli.CommandLine.Option;
import sunbeam.app.files.input.PngText;
import sunbeam.app.files.output.TevClient;
import sunbeam.app.picture.LinearPicture;
import sunbeam.app.scene.SceneSettings;
import sunbeam.app.terminal.UsageException;
import sunbeam.precompute.color.DisplayTransform;
import sunbeam.precompute.color.Primaries;
import sunbeam.precompute.color.Tone;
import sunbeam.precompute.files.InputException;
import sunbeam.precompute.plan.Preset;
import sunbeam.precompute.setting.Choices;
import sunbeam.precompute.setting.ValueKind;
import sunbeam.precompute.units.Decimals;

/** Options {@code --exposure}, {@code --tone} and {@code --primaries}; a picocli mixin. */
public final class DisplayOptions {
    private static final String AUTOMATIC = "auto";
    private static final String FIRST = "first";
    private static final ValueKind<Tone> TONES = ValueKind.word("CURVE", Tone.class);

    @Option(
            names = "--exposure",
            paramLabel = "FACTOR",
            defaultValue = AUTOMATIC,
            description = "Factor for the linear colors; auto (default): chosen from the pictures, one for all; first:"
                    + " chosen from the first; or FILE.png, a picture of Sunbeam whose exposure is used.")
    private String exposure;

    @Option(
            names = "--tone",
            paramLabel = "CURVE",
            description = "Display of light brighter than the screen: compress (default) keeps its hue; clip cuts each"
                    + " channel, as the thesis does (default with --preset thesis); gamma also has the exponent 1 / 2.5 of"
                    + " the thesis's program.")
    private String tone;

    @Option(names = "--primaries", paramLabel = "RGB", description = SceneSettings.PRIMARIES_HELP)
    private String primaries;

    /** Returns the rule that chooses one factor of linear colors for all pictures; reads the picture that {@code --exposure} may name. */
    public ToDoubleFunction<List<LinearPicture>> parse() {
        display(1, Choices.none());
        if (isAutomatic()) {
            int limit = isOfAll() ? Integer.MAX_VALUE : 1;
            return list -> LinearPicture.exposure(list.stream().limit(limit).toArray(LinearPicture[]::new));
        }
        boolean isPicture = exposure.toLowerCase(Locale.ROOT).endsWith(".png");
        double value = isPicture ? recorded() : Decimals.parse(exposure).orElse(Double.NaN);
        UsageException.throwIf(
                !(value > 0),
                "--exposure '" + exposure
                        + "' is neither auto nor a positive number, nor first, nor a picture (.png) to take it from"
                        + Decimals.commaRemedy(exposure));
        return pictures -> value;
    }

    /** Returns the transform to the screen; tone and primaries default to those of the method's preset. */
    public DisplayTransform display(double factor, Choices method) {
        boolean isThesis = Preset.isThesis(method);
        return new DisplayTransform(
                factor,
                parsed("--tone", tone, TONES, Tone.of(isThesis)),
                parsed("--primaries", primaries, SceneSettings.PRIMARIES.kind(), Primaries.of(isThesis)));
    }

    private static <T> T parsed(String option, String text, ValueKind<T> kind, T standard) {
        return text == null ? standard : UsageException.parsed(option + " ", () -> kind.parse(text));
    }

    /** True if the factor is computed from pictures. */
    public boolean isAutomatic() {
        return isOfAll() || exposure.equalsIgnoreCase(FIRST);
    }

    public boolean isOfAll() {
        return exposure.equalsIgnoreCase(AUTOMATIC);
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

    /** Option {@code --tev} of commands that draw pictures; a picocli mixin. */
    public static final class TevOption {
        @Option(
                names = "--tev",
                description =
                        "Also send the linear colors (Rec. 709 and alpha, before exposure) to the viewer tev, which"
                                + " has to run on this machine (port 14158): scenes tile by tile, maps when they are drawn.")
        private boolean asked;

        /** Returns the connection to tev, which must run; empty without the option. */
        public Optional<TevClient> connect(PrintWriter err) {
            return asked ? Optional.of(TevClient.connect(TevClient.PORT, err)) : Optional.empty();
        }
    }
}
