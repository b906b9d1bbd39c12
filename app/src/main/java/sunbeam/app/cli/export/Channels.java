package sunbeam.app.cli.export;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.DoubleStream;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.color.SpectralBands;
import sunbeam.precompute.color.Srgb;

/**
 * The channels along the last axis of an array of colors.
 *
 * @param kind of the channels
 * @param bands of spectral channels; unused for other kinds
 */
record Channels(Kind kind, SpectralBands bands) {

    enum Kind {
        XYZ("CIE X, Y, Z of diffracted power"),
        REC709("linear Rec. 709 red, green, blue of diffracted power, negative outside of the gamut"),
        SPECTRAL("diffracted power, mean over each band, weighted by a triangle that ends at the bands beside it");

        private final String words;

        Kind(String words) {
            this.words = words;
        }
    }

    int count() {
        return kind == Kind.SPECTRAL ? bands.count() : ColorGrid.CHANNELS;
    }

    /** Numbers that are in memory at once. */
    long numbers(GridShape shape) {
        return Math.max(ColorGrid.CHANNELS, count()) * shape.allTexels();
    }

    String words() {
        return kind.words;
    }

    /** Functions of the wavelength in which errors are measured: the light's, or three bands in the middle. */
    CieTable measured(CieTable light) {
        return kind == Kind.SPECTRAL ? bands.table(bands.tables() / 2) : light;
    }

    /** Metadata of these channels, which replaces that of X, Y, Z. */
    Map<String, Object> fields(Map<String, Object> ofColors) {
        Map<String, Object> fields = new LinkedHashMap<>(ofColors);
        if (kind == Kind.SPECTRAL) {
            fields.put("illuminant", "none: power is the same in all light");
            fields.put("observer", "none");
            fields.put("unit", "1: a flat mirror in specular direction under the asked window, at each wavelength");
            fields.put(
                    "wavelengths_nm",
                    DoubleStream.of(bands.nanometers()).boxed().toList());
        }
        return fields;
    }

    List<ColorGrid> grids(ColorGrid grid, GridBaker baker) {
        return kind == Kind.SPECTRAL ? baker.bands(grid, bands) : List.of(grid);
    }

    /** @param values receives all channels of the texel */
    void at(List<ColorGrid> grids, int slice, int texel, double[] values) {
        for (int c = 0; c < count(); c++) {
            ColorGrid grid = grids.get(c / ColorGrid.CHANNELS);
            double root = grid.roots()[slice][ColorGrid.CHANNELS * texel + c % ColorGrid.CHANNELS];
            values[c] = grid.level().scale() * root * root;
        }
        if (kind == Kind.REC709) {
            double x = values[0];
            double y = values[1];
            double z = values[2];
            for (int c = 0; c < ColorGrid.CHANNELS; c++) {
                values[c] = Srgb.linear(c, x, y, z);
            }
        }
    }
}
