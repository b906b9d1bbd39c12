/** Exit codes and messages of exceptions, by their types. */
package sunbeam.app.failure;
