package sunbeam.app.commands.figures;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import org.junit.jupiter.api.Test;
import sunbeam.app.terminal.UsageException;

class CatalogueTest {
    @Test
    void holdsTheThesissResultFiguresInOrder() {
        assertThat(Catalogue.all())
                .extracting(Figure::number)
                .containsExactly(
                        "4.9", "4.10", "4.11", "5.3", "5.4", "5.5", "5.6", "5.7", "5.8", "5.9", "5.10", "5.11", "5.12",
                        "5.13");
    }

    @Test
    void noTwoPicturesShareAFile() {
        List<String> names = Catalogue.all().stream()
                .flatMap(figure -> figure.panels().stream())
                .map(Panel::name)
                .toList();

        assertThat(names).doesNotHaveDuplicates();
    }

    @Test
    void selectsByNumber() {
        assertThat(Catalogue.select(List.of("5.10", "4.9")))
                .extracting(Figure::number)
                .containsExactly("4.9", "5.10");
        assertThatThrownBy(() -> Catalogue.select(List.of("5.99")))
                .isInstanceOf(UsageException.class)
                .hasMessageStartingWith("--only 5.99: no such figure; choose from 4.9, 4.10");
    }
}
