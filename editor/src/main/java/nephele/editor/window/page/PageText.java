package nephele.editor.window.page;

import nephele.editor.text.Text;
import nephele.editor.text.Words;

/** A text of the settings page in English, Brazilian and European Portuguese. */
public enum PageText implements Text {
    SETTINGS("Settings", "Configurações", "Definições"),
    GENERAL("General", "Geral", "Geral"),
    KEYS("Keys", "Teclas", "Teclas"),
    LANGUAGE("Language", "Idioma", "Idioma"),
    THEME("Theme", "Tema", "Tema"),
    LIGHT("Light", "Claro", "Claro"),
    DARK("Dark", "Escuro", "Escuro"),
    SCALE("Scale", "Escala", "Escala"),
    OPEN_FOLDER("Open settings folder", "Abrir a pasta das configurações", "Abrir a pasta das definições"),
    FOLDER_IS("The settings are in %s", "As configurações estão em %s", "As definições estão em %s"),
    CLOSE("Close", "Fechar", "Fechar"),
    FILTER("Search actions and keys", "Buscar ações e teclas", "Procurar ações e teclas"),
    ACTION("Action", "Ação", "Ação"),
    MENU("Menu", "Menu", "Menu"),
    CONFLICT("Conflict", "Conflito", "Conflito"),
    ALSO("%s: also %s", "%s: também %s", "%s: também %s"),
    CONFLICTS(
            "Keys with several actions: %s; the first action in this list gets them",
            "Teclas com várias ações: %s; a primeira ação desta lista as recebe",
            "Teclas com várias ações: %s; a primeira ação desta lista recebe-as"),
    NO_CONFLICTS("No conflicts", "Nenhum conflito", "Nenhum conflito"),
    REPLACE("Replace keys…", "Trocar teclas…", "Trocar teclas…"),
    ADD("Add a key…", "Acrescentar tecla…", "Acrescentar tecla…"),
    REMOVE("Remove keys", "Remover teclas", "Remover teclas"),
    RESET("Reset", "Restaurar", "Repor"),
    RESET_ALL("Reset all", "Restaurar todas", "Repor todas"),
    PRESS(
            "Press the key for \"%s\"; Esc keeps what it is",
            "Pressione a tecla de \"%s\"; Esc deixa como está", "Prime a tecla de \"%s\"; Esc deixa como está"),
    HOW(
            "Choose an action, then press Enter and the new key",
            "Escolha uma ação, depois pressione Enter e a nova tecla",
            "Escolhe uma ação, depois prime Enter e a nova tecla");

    private final Words words;

    PageText(String english, String brazilian, String european) {
        words = Words.of(english, brazilian, european);
    }

    @Override
    public Words words() {
        return words;
    }
}
