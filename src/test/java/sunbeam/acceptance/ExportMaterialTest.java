package sunbeam.acceptance;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

/** Reads an exported tensor file in Mitsuba. */
class ExportMaterialTest extends InWorkplace {
    private static final String SMALL = "--format bsdf --size 12MB --samples 0 --coherence-length 3um --theta-max 70";

    /** Mitsuba's eval gives the power of {@code reflectance} under the file's coherence length, but for the file's angular grid. */
    @Test
    void mitsubaReflectsWhatReflectanceSays() throws Exception {
        OtherPrograms.requireMitsuba();
        SunbeamResult made = workplace.here("export blaze --output b.bsdf " + SMALL);
        String length = made.stdout().replaceAll("(?s).*coherence length ([0-9.]+) um .*", "$1");
        List<double[]> rows = new ArrayList<>();
        for (int i = 0; i < 60; i++) {
            // Around the plane of the orders.
            rows.add(new double[] {i, 7 * i % 20, 11 * i % 60, i % 2 == 0 ? 180 : 5, 450 + 3 * i});
        }
        workplace.reflectance(
                "blaze", CsvFile.ofDirections(rows), "--average ensemble --coherence-length " + length + "um");

        String said = OtherPrograms.python(workplace.folder(), "-c", """
                import csv, numpy as np, mitsuba as mi
                mi.set_variant('llvm_ad_spectral')
                bsdf = mi.load_dict({'type': 'measured', 'filename': 'b.bsdf'})
                rows = list(csv.DictReader(open('reflectance.csv')))
                col = {n: np.array([float(r[n]) for r in rows]) for n in rows[0]}
                def vector(t, p):
                    t, p = np.radians(col[t]), np.radians(col[p])
                    return mi.Vector3f(*(mi.Float(x.astype('f4')) for x in (np.sin(t) * np.cos(p), np.sin(t) * np.sin(p), np.cos(t))))
                si = mi.SurfaceInteraction3f()
                si.wi = vector('theta_r', 'phi_r')
                si.wavelengths = mi.Spectrum(mi.Float(col['wavelength'].astype('f4')))
                read = np.array(bsdf.eval(mi.BSDFContext(), si, vector('theta_i', 'phi_i')))[0]
                exact = col['brdf'] * np.cos(np.radians(col['theta_i']))
                print(np.median((abs(read - exact) / exact)[exact > 1e-3 * exact.max()]))
                """);

        // Median error of a file of 12 MB.
        assertThat(Double.parseDouble(said.strip())).isLessThan(0.25);
        assertThat(made.stdout()).contains("error of power as it is read");
    }
}
