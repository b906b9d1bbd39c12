package sunbeam.app.files.cache;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import sunbeam.precompute.analysis.GratingPeriod;
import sunbeam.precompute.analysis.GratingPeriod.Certainty;
import sunbeam.precompute.analysis.SpatialFrequency;
import sunbeam.precompute.analysis.WaveLimit;
import sunbeam.precompute.files.Sha256;
import sunbeam.precompute.patch.Patch;

/** Cache of the periods of patches, whose search takes longer than the rest of {@code inspect}. */
public record PeriodCache(BlobCache blobs) {
    private static final ObjectMapper JSON = new ObjectMapper();
    private static final int MOST_BYTES = 1 << 16;

    /** A period as JSON has it: the strongest wave first, no limit if it is null. */
    private record Stored(
            List<SpatialFrequency> waves, double[] numbers, Certainty certainty, String reason, WaveLimit limit) {
        static Stored of(GratingPeriod period) {
            return new Stored(
                    Stream.concat(Stream.of(period.wave()), period.others().stream())
                            .toList(),
                    new double[] {
                        period.low(), period.high(), period.azimuthHalfWidth(), period.periods(), period.share()
                    },
                    period.certainty(),
                    period.reason(),
                    period.limit().orElse(null));
        }

        GratingPeriod period() {
            return new GratingPeriod(
                    waves.get(0),
                    numbers[0],
                    numbers[1],
                    numbers[2],
                    numbers[3],
                    numbers[4],
                    waves.subList(1, waves.size()),
                    certainty,
                    reason,
                    Optional.ofNullable(limit));
        }
    }

    /** Returns {@link GratingPeriod#of}, which depends on scan, repetition and faults alone. */
    public GratingPeriod of(Patch patch) {
        String identity = patch.scan().digest() + "|" + patch.repetition() + "|" + patch.faults();
        byte[] bytes = blobs.get("period of " + Sha256.of(identity), MOST_BYTES, () -> bytes(GratingPeriod.of(patch)));
        try {
            return JSON.readValue(bytes, Stored.class).period();
        } catch (IOException impossible) {
            throw new UncheckedIOException(impossible);
        }
    }

    private static byte[] bytes(GratingPeriod period) {
        try {
            return JSON.writeValueAsBytes(Stored.of(period));
        } catch (JsonProcessingException impossible) {
            throw new UncheckedIOException(impossible);
        }
    }
}
