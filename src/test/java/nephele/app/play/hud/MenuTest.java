package nephele.app.play.hud;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import nephele.app.play.hud.Menu.Choice;
import nephele.app.play.hud.Menu.Entry;
import nephele.app.settings.Settings;
import nephele.engine.render.pass.overlay.FontAtlas;
import nephele.engine.render.pass.overlay.OverlayCanvas;
import org.junit.jupiter.api.Test;

class MenuTest {
    private static Menu menu(int entries) {
        List<Entry> all = new ArrayList<>();
        for (int i = 0; i < entries; i++) {
            all.add(new Entry("entry " + i, "value", new Choice.Step(Settings.FIELD_OF_VIEW, 1)));
        }
        all.add(new Entry("quit", Choice.Plain.QUIT));
        return new Menu("m", "Menu", List.of("a line"), all, 0, 0, null, "foot");
    }

    @Test
    void theSelectionGoesAroundBothEnds() {
        assertEquals(4, menu(4).moved(-1).selected());
        assertEquals(0, menu(4).moved(5).selected());
    }

    @Test
    void aRowOutsideTheMenuSelectsNothingNew() {
        var menu = menu(4).moved(1);
        assertEquals(menu, menu.pointedAt(-1));
        assertEquals(menu, menu.pointedAt(99));
        assertEquals(2, menu.pointedAt(2).selected());
    }

    @Test
    void leftAndRightStepOnlySettings() {
        assertEquals(new Choice.Step(Settings.FIELD_OF_VIEW, -1), menu(1).stepped(-1));
        assertNull(menu(1).moved(1).stepped(1));
    }

    /** In every window size each selected entry is in the panel, at its own row, and the panel in the window. */
    @Test
    void theSelectedEntryIsVisibleInEveryWindow() {
        for (double[] size : new double[][] {{640, 360}, {320, 180}, {1280, 720}, {2560, 1080}, {400, 900}}) {
            var area = new Area(size[0], size[1]);
            for (int selected = 0; selected <= 14; selected++) {
                var panel = new MenuPanel(menu(14).moved(selected), area);
                boolean isSeen = false;
                for (double y = 0; y < area.height(); y++) {
                    isSeen |= panel.rowAt(area.width() / 2, y) == selected;
                }
                assertTrue(isSeen, selected + " in " + area);
                assertTrue(panel.bottom() <= area.height() + 1 || area.height() < 200, area + ": " + panel.bottom());
            }
        }
    }

    /** A message in the foot is whole, or ends in dots, and stays above the panel's lower edge. */
    @Test
    void aLongMessageStaysInsideThePanel() {
        var canvas = new OverlayCanvas(new FontAtlas());
        String path = "/home/somebody/" + "a-folder-with-a-name/".repeat(3) + "room.json";
        String problem = "materials[1].texture: there is no such file; put it into the level's folder. ";
        double before = 99;
        for (int times : new int[] {1, 2, 9}) {
            var foot = MenuPanel.foot(canvas, path + ": " + problem.repeat(times));
            assertTrue(
                    MenuPanel.firstBaseline(foot) + (foot.lines().size() - 1) * foot.em() * 1.27 < 66,
                    times + ": " + foot);
            assertTrue(foot.em() <= before && foot.em() >= 10, times + ": " + foot);
            assertEquals(times == 9, foot.lines().get(foot.lines().size() - 1).endsWith(" …"), times + ": " + foot);
            before = foot.em();
        }
        assertEquals(List.of("Esc back"), MenuPanel.foot(canvas, "Esc back").lines());
    }
}
