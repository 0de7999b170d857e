package nephele.app.play;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import nephele.app.play.hud.HudContent;
import nephele.app.play.hud.Menu;
import nephele.app.play.hud.Menu.Choice;
import nephele.app.play.hud.Menu.Entry;
import nephele.app.settings.GameSetting;
import nephele.app.settings.Phrase;
import nephele.app.settings.Settings;
import nephele.app.window.Control;
import nephele.app.window.Input;
import nephele.engine.level.Language;

/** The pages of the settings: the groups, each group, and the keys, all with a line of help for the chosen entry. */
final class SettingsPages {
    private final PageWriter writer;

    SettingsPages(PageWriter writer) {
        this.writer = writer;
    }

    /** Returns the page of the groups; the language, which leads to all others, stands in it itself. */
    Menu groups() {
        List<Entry> entries = new ArrayList<>();
        entries.add(entry(Settings.LANGUAGE));
        for (GameSetting.Group group : GameSetting.Group.values()) {
            entries.add(new Entry(writer.text(Phrase.ofGroup(group)), new Choice.OpenSettings(group))
                    .helped(writer.text(Phrase.ofGroupHelp(group))));
        }
        entries.add(new Entry(writer.text(Phrase.KEYS), new Choice.Open(Menu.Page.KEYS))
                .helped(writer.text(Phrase.ABOUT_KEYS)));
        entries.add(writer.back());
        return writer.page("settings", writer.text(Phrase.SETTINGS), List.of(), entries, Choice.Plain.BACK);
    }

    Menu of(GameSetting.Group group) {
        List<Entry> entries = new ArrayList<>();
        Settings.of(group).forEach(setting -> entries.add(entry(setting)));
        entries.add(writer.back());
        String name = "settings-" + GameSetting.word(group);
        return writer.page(name, writer.text(Phrase.ofGroup(group)), List.of(), entries, Choice.Plain.BACK);
    }

    /** Returns the page on which a setting stands. */
    Menu pageOf(GameSetting<?> setting) {
        return setting.group() == null ? groups() : of(setting.group());
    }

    private Entry entry(GameSetting<?> setting) {
        return new Entry(
                        writer.text(Phrase.ofSetting(setting.key())),
                        "‹ " + value(setting) + " ›",
                        new Choice.Step(setting, 1))
                .helped(writer.text(Phrase.ofHelp(setting.key())));
    }

    /** @param waiting the control whose key is awaited; null for none */
    Menu keys(Control waiting) {
        var keys = new HudContent.Keys(
                Settings.bindings(writer.files().settings()), Input.Device.KEYBOARD, writer.language());
        List<Entry> entries = new ArrayList<>();
        for (Control control : Settings.KEYS.keySet()) {
            String value = control == waiting ? writer.text(Phrase.PRESS_KEY) : keyText(keys, control);
            entries.add(new Entry(keys.meaning(control), value, new Choice.Bind(control))
                    .helped(writer.text(Phrase.HELP_KEYS)));
        }
        entries.add(writer.back());
        return writer.page("keys", writer.text(Phrase.KEYS), List.of(), entries, Choice.Plain.BACK);
    }

    /** Returns a control's keys, and the control that has one of them too. */
    private String keyText(HudContent.Keys keys, Control control) {
        Control other = keys.bindings().conflict(control);
        String names = keys.names(control).isEmpty() ? writer.text(Phrase.NO_KEY) : keys.names(control);
        return other == null ? names : names + " – " + Phrase.ALSO.in(writer.language(), keys.meaning(other));
    }

    private <T> String value(GameSetting<T> setting) {
        T value = writer.files().settings().get(setting);
        if (value instanceof Language language) {
            return language.title();
        }
        if (value instanceof Enum<?> word) {
            return writer.text(Phrase.ofWord(word));
        }
        if (value instanceof String text) {
            return text.equals(Settings.AUTO_RESOLUTION)
                    ? writer.text(Phrase.ofWord(Settings.QualityPreset.AUTO))
                    : text.replace('x', '×');
        }
        double number = (Double) value;
        if (setting.equals(Settings.FRAME_CAP) && number == 0) {
            return writer.text(Phrase.WORD_OFF);
        }
        if (setting.equals(Settings.AUTO_FRAME_RATE) && number == 0) {
            return writer.text(Phrase.ofWord(Settings.QualityPreset.AUTO));
        }
        String unit = setting.equals(Settings.FIELD_OF_VIEW) ? "°" : "";
        return (number == Math.rint(number) && !setting.equals(Settings.MOUSE_SPEED)
                        ? Long.toString((long) number)
                        : String.format(Locale.ROOT, "%.1f", number))
                + unit;
    }
}
