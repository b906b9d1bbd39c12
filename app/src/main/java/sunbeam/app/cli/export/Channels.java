package sunbeam.app.cli.export;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.DoubleStream;
import sunbeam.precompute.analysis.EnergyDivisor;
import sunbeam.precompute.color.CieTable;
import sunbeam.precompute.color.SpectralBands;
import sunbeam.precompute.color.Srgb;
import sunbeam.precompute.optics.Direction;

/**
 * Channels along the last axis of an exported array of colors.
 *
 * @param kind meaning of the channels
 * @param bands wavelength bands of spectral channels; unused for other kinds
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

    long numbers(GridShape shape) {
        return Math.max(ColorGrid.CHANNELS, count()) * shape.allTexels();
    }

    String words() {
        return kind.words;
    }

    CieTable errorWeights(CieTable light) {
        return kind == Kind.SPECTRAL ? bands.table(bands.tables() / 2) : light;
    }

    /** Returns the metadata of these channels: that of X, Y, Z, with other values where bands differ. */
    Map<String, Object> fields(Map<String, Object> ofColors) {
        Map<String, Object> fields = new LinkedHashMap<>(ofColors);
        if (kind == Kind.SPECTRAL) {
            fields.put("illuminant", "none: power is the same in all light");
            fields.put("observer", "none");
            fields.put("unit", "1: a flat mirror in specular direction under the asked window, at each wavelength");
            fields.put(
                    "wavelengths_m",
                    DoubleStream.of(bands.nanometers())
                            .map(nanometers -> nanometers / 1e9)
                            .boxed()
                            .toList());
        }
        return fields;
    }

    List<ColorGrid> grids(ColorGrid grid, GridBaker baker) {
        return kind == Kind.SPECTRAL ? baker.bands(grid, bands) : List.of(grid);
    }

    /** Returns the divisor of a channel under a light: for colors, the mean by luminance. */
    double divisor(EnergyDivisor divisor, int channel, Direction light, CieTable cie) {
        return kind == Kind.SPECTRAL
                ? divisor.at(light, bands.nanometers()[channel] * 1e-9)
                : divisor.ofColors(light, cie);
    }

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
