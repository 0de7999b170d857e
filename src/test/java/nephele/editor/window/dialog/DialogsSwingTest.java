package nephele.editor.window.dialog;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.event.KeyEvent;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import javax.swing.JComboBox;
import javax.swing.JLabel;
import javax.swing.JTextField;
import nephele.editor.action.ActionCall;
import nephele.editor.action.Actions;
import nephele.editor.action.EditorCommand;
import nephele.editor.action.EditorCommands;
import nephele.editor.action.EditorKeys;
import nephele.editor.action.ScriptInterface;
import nephele.editor.document.Selection;
import nephele.editor.panel.model.PaletteEntry;
import nephele.editor.record.EntityRef;
import nephele.editor.save.DocumentFile;
import nephele.editor.session.EditorSession;
import nephele.editor.session.EditorSetting;
import nephele.editor.session.EditorSetting.Theme;
import nephele.editor.session.EditorSettings;
import nephele.editor.text.EditorRefusal;
import nephele.editor.text.Words;
import nephele.editor.widget.AssetPictures;
import nephele.editor.window.WindowLook;
import nephele.engine.level.Language;
import nephele.workshop.prove.editor.PaintedPanel;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The dialogues without a display: search lists, forms, and the choice of an asset. */
@Execution(ExecutionMode.SAME_THREAD)
class DialogsSwingTest {
    private static final DocumentFile.Opened LEVEL = DocumentFile.open("levels/02-first-shot.json");

    private EditorSession session = session(EditorSettings.DEFAULT);
    private int closed;

    private static EditorSession session(EditorSettings settings) {
        WindowLook.apply(settings);
        EditorSession opened = new EditorSession(LEVEL.file(), LEVEL.level(), LEVEL.assets(), settings);
        opened.document()
                .select(Selection.of(
                        new EntityRef("solids", LEVEL.level().solids().get(0).id())));
        return opened;
    }

    private List<EditorCommand> commands() {
        return new EditorCommands(session, new ScriptInterface(() -> null), Actions.ALL).all();
    }

    private Words run(String action, Map<String, String> values) {
        try {
            Actions.named(action)
                    .orElseThrow()
                    .effect()
                    .run(new ActionCall(session, new ScriptInterface(() -> null), values));
            return Words.NONE;
        } catch (EditorRefusal failure) {
            return failure.words();
        }
    }

    private FormPanel form(String part) {
        ActionForm form = ActionForm.ALL.stream()
                .filter(each -> each.part().equals(part))
                .findFirst()
                .orElseThrow();
        return new FormPanel(form, session, values -> run(form.action(), values), () -> closed++);
    }

    private SearchList<EditorCommand> palette(List<EditorCommand> chosen) {
        List<EditorCommand> all = commands();
        return Searches.commands(
                all, new EditorKeys(all, Map.of()), session.language(), command -> command.ifPresent(chosen::add));
    }

    @ParameterizedTest
    @CsvSource({"DARK, 100, EN", "LIGHT, 100, PT_BR", "DARK, 200, PT_PT", "LIGHT, 200, PT_BR"})
    void nothingIsCutOff(Theme theme, int percent, Language language) throws Exception {
        session = session(PaintedPanel.settings(theme, percent, language));
        String look = "-" + theme + "-" + percent + "-" + language;
        List<String> cut = new ArrayList<>();
        for (ActionForm form : ActionForm.ALL) {
            cut.addAll(new PaintedPanel(form(form.part()))
                    .write(form.part() + look)
                    .clipped(session));
        }
        assertEquals(List.of(), cut);
        new PaintedPanel(palette(new ArrayList<>())).write("palette" + look);
        new PaintedPanel(Searches.kinds(language, any -> {})).write("add" + look);
        PaintedPanel assets = new PaintedPanel(new AssetDialog(
                        session, new DialogFrame(new JLabel()), new AssetPictures(session::assets, Runnable::run))
                .list(AssetFamily.PICTURE, any -> {}));
        // The first painting asks for the pictures.
        assets.picture();
        java.awt.EventQueue.invokeAndWait(() -> {});
        assets.write("assets" + look);
    }

    private static void press(SearchList<?> list, int code) {
        KeyEvent event = new KeyEvent(list.query(), KeyEvent.KEY_PRESSED, 0, 0, code, KeyEvent.CHAR_UNDEFINED);
        for (var listener : list.query().getKeyListeners()) {
            listener.keyPressed(event);
        }
    }

    @Test
    void theSearchIsTypedAndEnterChooses() {
        session.settings(session.settings().with(EditorSetting.LANGUAGE, Language.PT_BR));
        List<EditorCommand> chosen = new ArrayList<>();
        SearchList<EditorCommand> palette = palette(chosen);
        palette.query().setText("duplic");
        press(palette, KeyEvent.VK_ENTER);
        assertEquals("duplicate", chosen.get(0).id());
        palette.query().setText("grade mais");
        press(palette, KeyEvent.VK_DOWN);
        press(palette, KeyEvent.VK_ENTER);
        assertEquals("grid-coarser", chosen.get(1).id());
        palette.query().setText("desfazer");
        press(palette, KeyEvent.VK_ENTER);
        assertEquals(2, chosen.size(), "what is not possible is not chosen");
    }

    @Test
    void escGivesUp() {
        List<Optional<PaletteEntry>> ended = new ArrayList<>();
        SearchList<PaletteEntry> kinds = Searches.kinds(Language.PT_PT, ended::add);
        press(kinds, KeyEvent.VK_ESCAPE);
        kinds.query().setText("nuvem");
        press(kinds, KeyEvent.VK_ENTER);
        assertEquals(Optional.empty(), ended.get(0));
        assertEquals("environment.clouds", ended.get(1).orElseThrow().section());
    }

    @Test
    void aNewIdIsCheckedWhileItIsTyped() {
        FormPanel rename = form("rename");
        JTextField text = (JTextField) rename.first();
        assertEquals(LEVEL.level().solids().get(0).id(), text.getText());
        text.setText(LEVEL.level().solids().get(1).id());
        assertFalse(rename.acceptButton().isEnabled());
        assertTrue(message(rename).contains(text.getText()), message(rename));
        text.setText("");
        assertFalse(rename.acceptButton().isEnabled());
        text.setText("renamed");
        rename.acceptButton().doClick();
        assertEquals("renamed", session.document().level().solids().get(0).id());
        assertEquals(1, closed);
    }

    private static String message(FormPanel form) {
        return PaintedPanel.all(form, JLabel.class).stream()
                .filter(label -> "message".equals(label.getName()))
                .findFirst()
                .orElseThrow()
                .getText();
    }

    @Test
    void numbersMayBeSumsAndAFailureKeepsTheFormOpen() {
        FormPanel move = form("move");
        List<JTextField> fields = PaintedPanel.all(move, JTextField.class);
        fields.get(0).setText("one");
        assertFalse(move.acceptButton().isEnabled());
        fields.get(0).setText("1/4");
        move.acceptButton().doClick();
        assertEquals(1, closed);
        assertTrue(session.document().isModified());
        FormPanel set = form("set");
        JTextField value = PaintedPanel.all(set, JTextField.class).get(0);
        value.setText("no such material");
        assertFalse(set.acceptButton().isEnabled(), message(set));
        ((JComboBox<?>) set.first()).setSelectedIndex(1);
        value.setText("neither true nor false");
        set.acceptButton().doClick();
        assertEquals(1, closed);
        assertFalse(message(set).isBlank());
    }

    @Test
    void everyFormRunsAsItIsShown() {
        for (ActionForm form : ActionForm.ALL) {
            if (!form.part().equals("set")) {
                form(form.part()).acceptButton().doClick();
            }
        }
        assertEquals(ActionForm.ALL.size() - 1, closed);
    }

    @Test
    void assetsAreThoseOfTheFamilyThatTheLevelCanName() {
        List<String> pictures = AssetFamily.of("texture", "").ids(session.assets());
        assertTrue(pictures.stream().anyMatch(id -> id.startsWith("textures/")), pictures.toString());
        assertTrue(pictures.stream().allMatch(id -> session.assets().exists(id)));
        List<String> models = AssetFamily.of("file", "models/any.obj").ids(session.assets());
        assertTrue(models.stream().allMatch(id -> AssetFamily.of(id) == AssetFamily.MODEL));
        assertFalse(models.isEmpty());
    }

    @Test
    void whatIsAddedLiesInView() {
        assertEquals(
                "",
                run("add", Map.of("kind", "bodies.box", "at", EditorDialogs.text(session)))
                        .english());
        assertEquals(
                LEVEL.level().bodies().size() + 1,
                session.document().level().bodies().size());
    }
}
