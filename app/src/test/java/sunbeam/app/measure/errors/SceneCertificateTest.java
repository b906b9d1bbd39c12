package sunbeam.app.measure.errors;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import org.junit.jupiter.api.Test;

/** What is said of pixels of which there is little to say. */
class SceneCertificateTest {
    private static Comparison pixel(double computed, double exact) {
        return new Comparison(new double[] {computed, computed, computed}, new double[] {exact, exact, exact}, 1);
    }

    @Test
    void ofPixelsWithoutLightNoErrorIsTold() {
        List<Comparison> dark = List.of(pixel(0, 0), pixel(1e-12, 2e-12));
        SceneCertificate certificate = SceneCertificate.of(dark, 1);
        assertThat(certificate.missed()).isFalse();
        assertThat(certificate.summary()).contains("darker than 1e-09").doesNotContain("NaN");

        CrawlCertificate crawl = CrawlCertificate.of(List.of(new CrawlCertificate.Change(dark.get(0), dark.get(1))), 1);
        assertThat(crawl.missed()).isFalse();
        assertThat(crawl.summary()).contains("darker than 1e-09").doesNotContain("NaN");
    }

    @Test
    void pixelsWithMuchDiffractedLightAreToldApart() {
        List<Comparison> body = Collections.nCopies(60, pixel(0.5, 0.5));
        List<Comparison> colors = List.of(pixel(0.1, 0.2), pixel(0.2, 0.2));
        List<Comparison> all = new ArrayList<>(body);
        all.addAll(colors);
        SceneCertificate certificate = SceneCertificate.of(all, 1, colors);
        assertThat(certificate.missed()).as("by the median of all").isFalse();
        assertThat(certificate.summary())
                .contains("in 2 of them, where more than a tenth of the light is diffracted", "which are few");
        assertThat(SceneCertificate.of(body, 1, List.of()).summary()).contains("in none of them");
        assertThat(SceneCertificate.of(body, 1).summary()).doesNotContain("diffracted");
    }

    @Test
    void whatStandsStillHasNoRatio() {
        Comparison still = pixel(0.2, 0.2);
        CrawlCertificate crawl = CrawlCertificate.of(List.of(new CrawlCertificate.Change(still, still)), 1);
        assertThat(crawl.missed()).isFalse();
        assertThat(crawl.summary()).contains("too little for eyes").doesNotContain("NaN");
    }

    @Test
    void ofNoPixelsNothingIsSaid() {
        SceneCertificate certificate = SceneCertificate.of(List.of(), 1);
        assertThat(certificate.missed()).isFalse();
        assertThat(certificate.summary()).contains("nothing to compare");
    }
}
