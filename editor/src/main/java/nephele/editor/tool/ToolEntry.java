package nephele.editor.tool;

import java.util.function.Function;
import nephele.editor.text.Words;

/**
 * A tool of the toolbar.
 *
 * @param id its name in scripts and settings
 * @param key default key, a letter or digit; empty for none
 */
public record ToolEntry(String id, Words title, Words description, String key, Function<ToolContext, Tool> make) {}
