package nephele.app.settings;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.regex.Pattern;
import nephele.app.play.hud.HudContent.Keys;
import nephele.app.window.Control;
import nephele.app.window.Input;
import nephele.app.window.KeyBindings;
import nephele.app.window.KeyNames;
import nephele.engine.level.Language;
import org.junit.jupiter.api.Test;

/** Every key that can be bound has a name of its own in each language, and every screen shows that name. */
class KeyPhrasesTest {
    private static final Pattern ENGLISH =
            Pattern.compile("\\b(Space|Up|Down|Left|Right|Keypad|Escape)\\b", Pattern.CASE_INSENSITIVE);

    @Test
    void everyKeyHasANameOfItsOwnInEachLanguage() {
        for (Language language : Language.values()) {
            var names = new HashSet<String>();
            for (String key : KeyNames.all()) {
                String name = Phrase.ofKey(key, language);
                assertTrue(names.add(name), language + ": two keys are called " + name);
                boolean isEnglish = language == Language.EN;
                boolean isPage = key.startsWith("Page"); // so is the key labelled
                assertTrue(isEnglish || isPage || !ENGLISH.matcher(name).find(), language + ": " + name);
            }
        }
        assertEquals("Espaço", Phrase.ofKey("Space", Language.PT_BR));
        assertEquals("Num Enter", Phrase.ofKey("Keypad Enter", Language.PT_PT));
        assertEquals("Rato 3", Phrase.ofKey("Mouse 3", Language.PT_PT));
        assertEquals("clique esquerdo", Phrase.ofKeyInSentence("Mouse 1", Language.PT_PT));
    }

    /** The text of a control names the key that runs, whichever it is. */
    @Test
    void noTextNamesAKeyThatThePlayerHasReplaced() {
        var keys = new Keys(
                KeyBindings.of(Map.of(Control.RUN, List.of("Right Alt"), Control.SCREENSHOT, List.of("F12"))),
                Input.Device.KEYBOARD,
                Language.PT_BR);
        assertEquals("imagem (Alt dir.: sem textos)", keys.meaning(Control.SCREENSHOT));
        assertEquals("mover a divisória (Alt dir.: devagar)", keys.withRun(Phrase.MOVE_WIPE));
        for (Phrase phrase : Phrase.values()) {
            boolean isKey = phrase.name().startsWith("KEY_");
            assertFalse(!isKey && phrase.in(Language.EN).contains("Shift"), phrase.toString());
        }
    }

    /** What one picks up is "pego" in Brazil and "agarrado" in Portugal, on every screen. */
    @Test
    void wordsOfOneVariantAreNotInTheOther() {
        var brazilian = Pattern.compile("\\b(pegar|mouse|tela|fases?|pular|quadros|salvo)\\b");
        var european = Pattern.compile("\\b(agarrar|rato|ecrã|n[ií]ve(l|is)|saltar|guardado|contacto)\\b");
        var wrong = new ArrayList<String>();
        for (Phrase phrase : Phrase.values()) {
            if (brazilian.matcher(phrase.in(Language.PT_PT).toLowerCase()).find()
                    || european.matcher(phrase.in(Language.PT_BR).toLowerCase()).find()) {
                wrong.add(phrase.name());
            }
        }
        assertEquals(List.of(), wrong);
    }
}
