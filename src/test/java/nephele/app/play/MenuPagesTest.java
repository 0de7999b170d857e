package nephele.app.play;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import nephele.app.play.hud.Area;
import nephele.app.play.hud.Hud;
import nephele.app.play.hud.Menu;
import nephele.app.play.hud.Menu.Choice;
import nephele.app.play.hud.Menu.Entry;
import nephele.app.settings.Settings;
import nephele.engine.level.Language;
import nephele.engine.render.pass.overlay.DrawnBounds;
import nephele.engine.render.pass.overlay.FontAtlas;
import nephele.host.compare.TechniquePair;
import nephele.host.named.LevelCatalogue;
import nephele.host.named.LevelName;
import nephele.host.named.SampleCatalogue;
import nephele.scenes.file.SceneName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Every page of the menu in every language and window: nothing is clipped, and each entry says what it is. */
class MenuPagesTest {
    /** Letters have a border without ink in the atlas, in points. */
    private static final double LETTER_BORDER = 7;

    /** So many letters stand in two lines. */
    private static final int LONGEST_HELP = 88;

    @TempDir
    static Path folder;

    /** All that is drawn lies in the window: of each entry in the smallest one, of each page in the others. */
    @Test
    void noPageReachesOutOfItsWindow() throws IOException {
        MenuPages pages = new MenuPages(folder);
        Hud hud = new Hud(new FontAtlas());
        int seen = 0;
        for (Language language : Language.values()) {
            for (Menu page : pages.in(language)) {
                page.entries().forEach(entry -> assertTrue(entry.help().length() <= LONGEST_HELP, entry.help()));
                for (int[] window : MenuPages.WINDOWS) {
                    Area area = MenuPages.area(window);
                    int rows = window == MenuPages.WINDOWS[0] ? page.entries().size() : 1;
                    for (int row = 0; row < rows; row++) {
                        var content = pages.content(page.moved(row), language);
                        DrawnBounds bounds = DrawnBounds.of(hud.canvas(content, area, 1));
                        String what = page.name() + " " + row + " " + language + " in " + area + ": " + bounds;
                        assertTrue(bounds.left() >= -LETTER_BORDER && bounds.top() >= -LETTER_BORDER, what);
                        assertTrue(bounds.right() <= area.width() + LETTER_BORDER, what);
                        assertTrue(bounds.bottom() <= area.height() + LETTER_BORDER, what);
                        seen++;
                    }
                }
            }
        }
        assertTrue(seen > 900, seen + " pages");
    }

    @Test
    void everySettingStandsInAGroupWithALineOfHelp() throws IOException {
        MenuPages pages = new MenuPages(folder);
        List<Menu> all = pages.in(Language.EN);
        for (var setting : Settings.PAGE) {
            long times = all.stream()
                    .flatMap(page -> page.entries().stream())
                    .filter(entry -> entry.choice() instanceof Choice.Step step && step.setting() == setting)
                    .peek(entry -> assertTrue(!entry.help().isEmpty(), setting.key()))
                    .count();
            assertEquals(1, times, setting.key());
        }
    }

    @Test
    void theListOfLevelsTellsRecordAndPar() throws IOException {
        Menu levels = page("levels");
        assertEquals(LevelCatalogue.campaign().size() + 1, levels.entries().size());
        Menu.Card first = levels.entries().get(0).card();
        assertNotNull(first.picture());
        assertEquals(
                List.of(new Menu.Fact("Best time", "0:28.89", "par 0:30"), new Menu.Fact("Portals used", "0", "par 0")),
                first.facts());
        assertEquals("Find the way up to the belvedere.", first.text());
    }

    /** A level that cannot be played tells place and remedy, and starts nothing. */
    @Test
    void aBrokenLevelOfTheUserIsListedWithItsMessage() throws IOException {
        Menu own = page("your-levels");
        assertEquals(List.of("4 in your folder, broken: 2"), own.lines());
        Entry broken = own.entries().get(1);
        assertNull(broken.choice());
        assertEquals("broken", broken.value());
        assertTrue(broken.card().text().startsWith("player.feet: this must be an array"), broken.toString());
        assertTrue(broken.card().text().endsWith("… and 2 more"), broken.toString());
        Entry longest = own.entries().get(2);
        assertEquals("The long way round from the…", longest.label());
        Entry torn = own.entries().get(3);
        assertTrue(torn.card().text().startsWith("it is no whole zip file; ask its author"), torn.toString());
        assertInstanceOf(Choice.Play.class, own.entries().get(0).choice());
        Entry how = own.entries().get(4);
        Path levels = folder.resolve("levels");
        assertEquals(new Choice.ShowFolder(levels), how.choice());
        assertTrue(how.card().text().contains(levels.toString()), how.toString());
    }

    private static Menu page(String name) throws IOException {
        return new MenuPages(folder)
                .in(Language.EN).stream()
                        .filter(page -> page.name().equals(name))
                        .findFirst()
                        .orElseThrow();
    }

    /** Every sample that the game brings is in the list, once, in all languages; what the list names exists. */
    @Test
    void theListOfSamplesIsWhole() throws IOException {
        Set<String> listed = new TreeSet<>();
        for (SampleCatalogue.Group group : LevelCatalogue.samples().groups()) {
            assertEquals(Set.of(Language.values()), group.title().keySet());
            assertEquals(Set.of(Language.values()), group.about().keySet(), group.toString());
            for (SampleCatalogue.Sample sample : group.samples()) {
                assertEquals(Set.of(Language.values()), sample.title().keySet(), sample.file());
                assertEquals(Set.of(Language.values()), sample.about().keySet(), sample.file());
                assertTrue(Files.isRegularFile(Path.of(sample.file())), sample.file());
                if (sample.compare() != null) {
                    TechniquePair.parse(sample.compare());
                } else {
                    assertTrue(listed.add(sample.file()), sample.file() + " is listed twice");
                }
            }
        }
        try (Stream<Path> files = Files.list(Path.of("levels/samples"))) {
            Set<String> there = files.filter(LevelCatalogue::isLevel)
                    .map(Path::toString)
                    .collect(Collectors.toCollection(TreeSet::new));
            there.removeAll(listed);
            assertEquals(Set.of(), there, "add them to levels/samples.json");
        }
        assertTrue(listed.contains(SceneName.SAMPLE.typed()));
    }

    /** Levels are played, scenes of shapes shown in their viewer, techniques compared; Esc goes back from each page. */
    @Test
    void everySampleOpensInItsWay() throws IOException {
        List<Menu> pages = new MenuPages(folder).in(Language.EN);
        Map<Class<?>, Integer> ways = new HashMap<>();
        for (Menu page : pages) {
            if (page.name().startsWith("samples")) {
                assertEquals(Choice.Plain.BACK, page.escape());
                page.entries().forEach(entry -> ways.merge(entry.choice().getClass(), 1, Integer::sum));
            }
        }
        int groups = LevelCatalogue.samples().groups().size();
        assertEquals(groups, ways.get(Choice.OpenSamples.class));
        assertEquals(groups + 1, ways.get(Choice.Plain.class));
        assertTrue(ways.get(Choice.Show.class) >= 12, ways.toString());
        assertTrue(ways.get(Choice.Compare.class) >= 6, ways.toString());
        assertTrue(ways.get(Choice.Play.class) >= 90, ways.toString());
    }

    /** A level of the user with the name of one of the campaign has progress of its own. */
    @Test
    void aLevelOfTheSameNameElsewhereIsAnotherOne() {
        LevelName campaign = LevelCatalogue.first();
        LevelName copy = new LevelName(folder.resolve(campaign.fileName()).toString());
        assertEquals(campaign.fileName(), campaign.key());
        assertEquals(copy.typed(), copy.key());
        assertTrue(LevelCatalogue.after(campaign).isPresent());
        assertTrue(LevelCatalogue.after(copy).isEmpty());
    }
}
