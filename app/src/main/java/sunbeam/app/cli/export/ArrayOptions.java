package sunbeam.app.cli.export;

import java.util.List;
import java.util.Locale;
import picocli.CommandLine.Option;
import sunbeam.app.files.input.LightTable;
import sunbeam.app.terminal.UsageException;
import sunbeam.precompute.color.SpectralBands;
import sunbeam.precompute.plan.LightSettings;
import sunbeam.precompute.setting.Choices;

final class ArrayOptions {
    /** Bands of 10 nm from 380 to 780 nm. */
    private static final int BANDS = 41;

    @Option(
            names = "--channels",
            paramLabel = "COLORS",
            description = "For npz: xyz (default); rec709, linear and negative where a color is outside of its gamut;"
                    + " or spectral, the power in --bands of wavelengths, whatever the light.")
    private Channels.Kind kind;

    @Option(
            names = "--bands",
            paramLabel = "N",
            description =
                    "Bands of --channels spectral and of bsdf, from the first to the last of --wavelengths. Default: "
                            + BANDS + ", every 10 nm; for bsdf as many as the width of orders needs.")
    private Integer bands;

    void refuse(String format) {
        if (kind != null) {
            throw new UsageException("--channels " + kind.name().toLowerCase(Locale.ROOT) + " is for --format npz, and "
                    + format + " has channels of its own; leave it out");
        }
        if (bands != null) {
            throw new UsageException("--bands is of --format npz and bsdf; leave it out");
        }
    }

    Channels channels(Choices light) {
        if (kind != Channels.Kind.SPECTRAL) {
            if (bands != null) {
                throw new UsageException("--bands is of --channels spectral; give that, too, or leave it out");
            }
            return new Channels(kind == null ? Channels.Kind.XYZ : kind, null);
        }
        return new Channels(kind, bands(light));
    }

    BsdfTable bsdfTable(Choices light) {
        if (kind != null) {
            throw new UsageException("--channels is for --format npz; bsdf has spectral bands; leave it out");
        }
        refuseLight(light);
        return new BsdfTable(
                light.get(LightSettings.WAVELENGTHS),
                bands == null ? 0 : bands(light).count());
    }

    private static void refuseLight(Choices light) {
        LightTable.requireNone(light, List.of(LightSettings.ILLUMINANT, LightSettings.OBSERVER));
    }

    private SpectralBands bands(Choices light) {
        refuseLight(light);
        try {
            return new SpectralBands(light.get(LightSettings.WAVELENGTHS), bands == null ? BANDS : bands);
        } catch (IllegalArgumentException wrong) {
            throw new UsageException("--bands " + wrong.getMessage());
        }
    }
}
