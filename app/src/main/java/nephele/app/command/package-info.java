/** The command line: one class a command, built only when it is named. */
package nephele.app.command;
