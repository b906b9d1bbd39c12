package sunbeam.app.viewer;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class ViewerMethodsTest {
    @Test
    void methodsThatDrawMeshesAreOffered() {
        assertThat(MethodChoice.ALL).extracting(MethodChoice::toString).contains("full", "table", "nmm");
        assertThat(MethodChoice.ALL).noneMatch(choice -> choice.toString().startsWith("reference"));
    }
}
