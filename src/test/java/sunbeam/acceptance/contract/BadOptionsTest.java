package sunbeam.acceptance.contract;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import sunbeam.acceptance.Complaint;
import sunbeam.acceptance.InWorkplace;

/** Wrong command lines are refused before anything is computed. */
class BadOptionsTest extends InWorkplace {
    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            quoteCharacter = '"',
            value = {
                "brdf-map --size 0|--size 0 is out of range; give 1 to",
                "brdf-map --size 100000|--size 100000 is out of range; give 1 to",
                "brdf-map --theta-i 90|--theta-i 90 deg is out of range; give 0 deg to 89.9 deg",
                "brdf-map --exposure -2|--exposure '-2' is neither auto nor a positive number",
                "brdf-map --terms 0|--terms 0 is out of range; give 1 to",
                "brdf-map --radius 99|--radius 99 is out of range; give 0 to",
                "brdf-map --wavelength-step 0nm|--wavelength-step 0 m is out of range; give",
                "brdf-map --coherence-length 1m|--coherence-length 1 m is out of range; give",
                "brdf-map --tolerance 0|--tolerance 0 is out of range; give 1e-5 to 1",
                "brdf-map --tolerance 1e-7|--tolerance 1e-7 is finer than float32 can reach, which is 1e-5",
                "brdf-map --preset thesis --tolerance 0.1|--tolerance 0.1 contradicts --preset thesis",
                "brdf-map --anchor floor|anchor floor is of the thesis's bins",
                "brdf-map --method gem --terms 5|--terms 5 belongs to --method full, nmm or pq, not gem; leave it out",
                "brdf-map --preset these|--preset \"these\" is not one of none, thesis",
                "brdf-map --output map.png --linear map.png|--linear map.png would be linear colors, which its name does not say; end it with .npy",
                "brdf-mop|unknown command 'brdf-mop' (did you mean brdf-map",
                "brdf-map --tolerance 1%|--tolerance \"1%\" is no number; write 0.01 for that many percent",
                "brdf-map --exposure Automatic|--exposure 'Automatic' is neither auto",
                "brdf-map --average ensembel|is not one of coherent, ensemble (did you mean ensemble?)",
                "brdf-map --sise 8|unknown option '--sise' (did you mean --size",
                "reflectance --directions in.csv|missing required option: '--output",
                "export blaze --format npz --output b.csv|--output",
                "export blaze --format npz --output b.npz --size many|--size",
                "export blaze --format npz --output b.npz --theta-max 91|--theta-max",
                "export blaze --format tiff --output b.npz|--format",
                "export blaze --format hdf5 --output b.h5|hdf5",
                "export blaze --format npz --output b.npz --channels rgb|--channels",
                "export blaze --format html --output b.html --channels rec709|--channels",
                "export blaze --format npz --output b.npz --channels spectral --bands 500|--bands 500",
                "export blaze --format npz --output b.npz --channels spectral --illuminant A|--illuminant",
                "export blaze --format npz --output b.npz --bands 20|--bands",
                "export blaze --format npz --output b.npz --channels spectral --wavelengths 532nm|--bands",
                "export blaze --format osl --output b --bands 20|--bands",
                "export blaze --format bsdf --output b.brdf|--output",
                "export blaze --format bsdf --output b.bsdf --channels xyz|--channels",
                "export blaze --format bsdf --output b.bsdf --illuminant A|--illuminant"
            })
    void areRefusedWithTheOptionItsValueAndWhatWouldDo(String commandLine, String words) throws Exception {
        Complaint.assertThatIt(workplace.here(commandLine), Complaint.USAGE, words);
        assertThat(workplace.files()).isEmpty();
        assertThat(workplace.tables()).isEmpty();
    }
}
