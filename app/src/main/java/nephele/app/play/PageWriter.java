package nephele.app.play;

import java.util.List;
import java.util.Locale;
import java.util.function.Supplier;
import nephele.app.play.hud.Menu;
import nephele.app.play.hud.Menu.Choice;
import nephele.app.play.hud.Menu.Entry;
import nephele.app.settings.Phrase;
import nephele.app.settings.PlayerFiles;
import nephele.app.settings.Settings;
import nephele.app.window.Input;
import nephele.engine.level.Language;

/**
 * Writes pages of the menu, with a foot that explains the keys, in the player's language.
 *
 * @param device the one whose keys the pages name
 */
record PageWriter(PlayerFiles files, Supplier<Input.Device> device) {
    private static final double TICKS_PER_SECOND = 120;

    Menu page(String name, String title, List<String> lines, List<Entry> entries, Choice escape) {
        boolean isPad = device.get() == Input.Device.GAMEPAD;
        String foot = text(isPad ? Phrase.PAD_MENU_KEYS : Phrase.MENU_KEYS);
        String back = isPad ? "B" : Phrase.ofKey("Escape", language());
        if (escape == Choice.Plain.RESUME) {
            foot += "     " + back + "  " + text(Phrase.FOOT_CONTINUE);
        } else if (escape == Choice.Plain.BACK) {
            foot += "     " + back + "  " + text(Phrase.FOOT_BACK);
        }
        return new Menu(name, title, lines, entries, 0, 0, escape, foot);
    }

    /** Returns the entry that leads back to the page before. */
    Entry back() {
        return new Entry(text(Phrase.BACK), Choice.Plain.BACK);
    }

    String text(Phrase phrase) {
        return phrase.in(language());
    }

    Language language() {
        return files.settings().get(Settings.LANGUAGE);
    }

    /** Returns minutes, seconds and hundredths. */
    static String time(long ticks) {
        long hundredths = Math.round(ticks / TICKS_PER_SECOND * 100);
        return String.format(Locale.ROOT, "%d:%02d.%02d", hundredths / 6000, hundredths / 100 % 60, hundredths % 100);
    }
}
