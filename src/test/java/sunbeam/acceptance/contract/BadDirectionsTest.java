package sunbeam.acceptance.contract;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import sunbeam.acceptance.Complaint;
import sunbeam.acceptance.InWorkplace;
import sunbeam.acceptance.SunbeamResult;

/** Unusable directions are reported in one line with file, place, value and remedy. */
class BadDirectionsTest extends InWorkplace {
    @Test
    void aListThatIsNotThere() throws Exception {
        Complaint.assertThatIt(
                reflectance(), Complaint.UNUSABLE_INPUT, "cannot read in.csv: there is no such file; check the name");
        assertThat(workplace.files()).isEmpty();
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "theta_i,phi_i,theta_r|0,0,0|it has no column phi_r",
                "theta_i,phi_i,theta_r,phi_r|0,0,95,0|line 2, column theta_r: 95.0 must lie in 0..89.999 degrees",
                "theta_i,phi_i,theta_r,phi_r|-1,0,0,0|line 2, column theta_i: -1.0 must lie in 0..89.999 degrees",
                "theta_i,phi_i,theta_r,phi_r|0,1e300,0,0|line 2, column phi_i: 1.0E300 must lie in -36000..36000 degrees",
                "theta_i,phi_i,theta_r,phi_r|0,north,0,0|line 2, column phi_i: 'north' is not a finite number",
                "theta_i,phi_i,theta_r,phi_r,wavelength|0,0,0,0,5.5e-7|column wavelength: 5.5E-7 must lie in 380..780 nm",
                "theta_i,phi_i,theta_r,phi_r,wavelength|0,0,0,0|line 2: 4 fields, but the header has 5",
                "theta_i;phi_i;theta_r;phi_r|0;0;0;0|separate columns by commas"
            })
    void aListWithAMistake(String header, String row, String words) throws Exception {
        Files.writeString(workplace.resolve("in.csv"), header + "\n" + row + "\n");

        Complaint.assertThatIt(reflectance(), Complaint.UNUSABLE_INPUT, "in.csv", words);

        assertThat(workplace.files()).containsExactly("in.csv");
    }

    private SunbeamResult reflectance() throws IOException {
        return workplace.here("reflectance --patch blaze --directions in.csv --output out.csv");
    }
}
