package sunbeam.precompute.method;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.patch.Patch;
import sunbeam.precompute.patch.PatchSettings;
import sunbeam.precompute.prepare.Crop;
import sunbeam.precompute.setting.Origin;
import sunbeam.precompute.setting.SettingException;

class FittingPartTest {
    private static final double PITCH = 1e-6;

    /** 64 x 32 samples. */
    private static Patch patch(Optional<Crop> ofFile) {
        HeightMap scan = new HeightMap(64, 32, PITCH, PITCH, new double[64 * 32]);
        return new Patch(
                "scan",
                scan,
                scan,
                "made up",
                List.of(),
                List.of(),
                List.of(),
                List.of(),
                ofFile,
                Patch.Repetition.NONE);
    }

    private static void planUpTo(double width, Patch part) {
        if (part.scan().width() > width * (1 + 1e-9)) {
            throw new SettingException(PatchSettings.CROP, "is too large");
        }
    }

    @Test
    void theLargestHalvedPartThatIsPlannedIsNamed() {
        Patch whole = patch(Optional.empty());
        FittingPart part =
                FittingPart.of(whole, tried -> planUpTo(16e-6, tried)).orElseThrow();
        assertThat(part.parts()).isEqualTo(4);
        assertThat(part.sentence(whole).in(Origin.PROGRAM))
                .isEqualTo("; a part of 1/4 of its width and height can be drawn as it is (crop 24um:40um,12um:20um)");
        assertThat(FittingPart.of(whole, tried -> planUpTo(1e-6, tried))).isEmpty();
    }

    /** A crop counts from the file's corner, not from that of the part which is in use. */
    @Test
    void aPartOfACroppedScanIsNamedInTheFile() {
        Patch cropped = patch(Optional.of(new Crop(100e-6, 164e-6, 7e-6, 39e-6)));
        FittingPart part =
                FittingPart.of(cropped, tried -> planUpTo(32e-6, tried)).orElseThrow();
        assertThat(part.sentence(cropped).in(Origin.PROGRAM)).endsWith("(crop 116um:148um,15um:31um)");
    }
}
