package nephele.editor.action;

import java.awt.event.KeyEvent;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.BiPredicate;

/**
 * The keys of commands: the defaults, or what the user has chosen instead. A key is found by the character of the user's
 * layout with the modifiers held, then by its place on the keyboard, then by a sign that the layout writes with Shift or
 * AltGr, so that other layouts than the US one miss none.
 */
public final class EditorKeys {
    private final Map<String, List<KeyText>> keys = new LinkedHashMap<>();

    /** @param chosen keys by command id; a text that is no key is left out */
    public EditorKeys(List<EditorCommand> commands, Map<String, List<String>> chosen) {
        for (EditorCommand command : commands) {
            List<String> texts = chosen.getOrDefault(command.id(), command.keys());
            keys.put(
                    command.id(),
                    texts.stream().flatMap(text -> KeyText.parse(text).stream()).toList());
        }
    }

    /** Returns the keys of a command. */
    public List<KeyText> of(String commandId) {
        return keys.getOrDefault(commandId, List.of());
    }

    /** Returns the id of the command to which a pressed key belongs. */
    public Optional<String> find(KeyEvent pressed) {
        return find(pressed, KeyText::isByCharacter)
                .or(() -> find(pressed, KeyText::isByPosition))
                .or(() -> find(pressed, KeyText::isByWrittenSign));
    }

    private Optional<String> find(KeyEvent pressed, BiPredicate<KeyText, KeyEvent> isHit) {
        return keys.entrySet().stream()
                .filter(entry -> entry.getValue().stream().anyMatch(key -> isHit.test(key, pressed)))
                .map(Map.Entry::getKey)
                .findFirst();
    }

    /** Returns the ids of the commands that have a key, in their order, for each key of several; the first receives it. */
    public Map<KeyText, List<String>> conflicts() {
        Map<KeyText, List<String>> claims = new LinkedHashMap<>();
        keys.forEach((id, texts) -> texts.stream().distinct().forEach(key -> claims.computeIfAbsent(
                        key, first -> new ArrayList<>())
                .add(id)));
        claims.values().removeIf(commands -> commands.size() == 1);
        return claims;
    }
}
