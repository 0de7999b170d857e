package nephele.app.play.hud;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.named.LevelName;

/**
 * A page of the menu as a value: entries, one of them selected. Keys move the selection cyclically, the mouse selects
 * an entry by its row.
 *
 * @param escape the choice of the Esc key
 */
public record Menu(String title, List<Entry> entries, int selected, Choice escape) {
    /** A line of the menu and the choice that it makes. */
    public record Entry(String label, Choice choice) {}

    /** A choice of the player. */
    public sealed interface Choice {
        record Continue() implements Choice {}

        record Restart() implements Choice {}

        record SelectLevel() implements Choice {}

        record ShowSettings() implements Choice {}

        /** Sets the rate at which the view turns upright after a portal. */
        record TurnUpright(int degreesPerSecond) implements Choice {}

        record Start(LevelName level) implements Choice {}

        record Back() implements Choice {}

        record Quit() implements Choice {}
    }

    public Menu {
        entries = List.copyOf(entries);
        if (entries.isEmpty() || selected < 0 || selected >= entries.size()) {
            throw new IllegalArgumentException("entry " + selected + " of " + entries.size() + " is selected");
        }
    }

    public static Menu pause() {
        return new Menu(
                "Nephele",
                List.of(
                        new Entry("Continue", new Choice.Continue()),
                        new Entry("Restart", new Choice.Restart()),
                        new Entry("Choose a level", new Choice.SelectLevel()),
                        new Entry("Settings", new Choice.ShowSettings()),
                        new Entry("Quit", new Choice.Quit())),
                0,
                new Choice.Continue());
    }

    public static Menu levels(List<LevelName> levels) {
        var entries = new ArrayList<Entry>();
        levels.forEach(level -> entries.add(new Entry(level.title(), new Choice.Start(level))));
        entries.add(new Entry("Back", new Choice.Back()));
        return new Menu("Choose a level", entries, 0, new Choice.Back());
    }

    public Menu moved(int steps) {
        return new Menu(title, entries, Math.floorMod(selected + steps, entries.size()), escape);
    }

    /** Returns the menu with that row selected; rows outside change nothing. */
    public Menu pointedAt(int row) {
        return row >= 0 && row < entries.size() ? new Menu(title, entries, row, escape) : this;
    }

    public Choice chosen() {
        return entries.get(selected).choice();
    }
}
