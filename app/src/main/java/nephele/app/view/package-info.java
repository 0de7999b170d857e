/** The third-person viewer of XML scenes: its controls and spring as values, and the window that shows them. */
package nephele.app.view;
