package nephele.app.play.hud;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;

import java.util.List;
import org.junit.jupiter.api.Test;

class MenuTest {
    @Test
    void theSelectionGoesAroundBothEnds() {
        var menu = Menu.pause();
        assertEquals(menu.entries().size() - 1, menu.moved(-1).selected());
        assertEquals(0, menu.moved(menu.entries().size()).selected());
    }

    @Test
    void aRowOutsideTheMenuSelectsNothingNew() {
        var menu = Menu.pause().moved(1);
        assertEquals(menu, menu.pointedAt(-1));
        assertEquals(menu, menu.pointedAt(99));
        assertEquals(2, menu.pointedAt(2).selected());
    }

    @Test
    void theFirstEntryContinuesAndTheLastOneQuits() {
        assertInstanceOf(Menu.Choice.Continue.class, Menu.pause().chosen());
        assertInstanceOf(Menu.Choice.Quit.class, Menu.pause().moved(-1).chosen());
    }

    @Test
    void aListOfNoLevelsStillLeadsBack() {
        assertInstanceOf(Menu.Choice.Back.class, Menu.levels(List.of()).chosen());
    }
}
