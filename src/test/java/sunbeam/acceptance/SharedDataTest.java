package sunbeam.acceptance;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class SharedDataTest {
    /** The repository itself has the surfaces and exact values of the strongest tests. */
    @Test
    void syntheticSurfacesAndTheirExactValuesAreInTheRepository() throws Exception {
        assertThat(HardCasesTest.cases()).hasSizeGreaterThanOrEqualTo(20).allSatisfy(hard -> {
            assertThat(SharedData.hardCase(hard.name()).resolve("in.csv")).isRegularFile();
            if (hard.patch().endsWith(".json")) {
                assertThat(SharedData.hardCase(hard.name()).resolve(hard.patch()))
                        .isRegularFile();
            }
        });
        assertThat(SharedData.patch("blaze")).startsWith(Sunbeam.repository());
        assertThat(SharedData.reference("power", "blaze").size()).isPositive();
        assertThat(SharedData.reference("xyz", "blaze").size()).isPositive();
    }
}
