package sunbeam.app.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.junit.jupiter.api.Test;

class ScenePictureTest {
    @Test
    void reducingAveragesLightAndCoverage() {
        ScenePicture fine = new ScenePicture(2, 2, new float[] {4, 8, 4, 1, 0, 0, 0, 0, 0, 0, 0, 0, 4, 4, 4, 1});
        ScenePicture coarse = fine.reduced(2);
        assertThat(coarse.rgba()).containsExactly(2, 3, 2, 0.5f);
        assertThat(coarse.linear().xyz()).as("of what is covered").containsExactly(4, 6, 4);
        assertThatThrownBy(() -> fine.reduced(3)).isInstanceOf(IllegalArgumentException.class);
    }

    @Test
    void partsGoWhereTheyBelong() {
        ScenePicture picture = ScenePicture.empty(3, 2);
        picture.put(new ScenePicture(1, 1, new float[] {1, 2, 3, 1}), 2, 1);
        assertThat(picture.rgba()[4 * 5 + 1]).isEqualTo(2);
        assertThatThrownBy(() -> picture.put(ScenePicture.empty(2, 1), 2, 0))
                .isInstanceOf(IllegalArgumentException.class);
    }
}
